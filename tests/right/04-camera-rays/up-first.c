// right: up by taking forward's part out of it (Gram and Schmidt), right from both
// task: camera_axes
    const Vec3 ahead = vec3_normalized(vec3_minus(view.at, view.from));
    const Vec3 upwards = vec3_normalized(view.up);
    *forward = ahead;
    *up = vec3_normalized(vec3_minus(upwards, vec3_scaled(ahead, vec3_dot(upwards, ahead))));
    *right = vec3_cross(*forward, *up);
