// right: the third axis as textbooks have it: backwards, and turned round at the end
// task: camera_axes
    const Vec3 back = vec3_normalized(vec3_minus(view.from, view.at));
    const Vec3 side = vec3_normalized(vec3_cross(vec3_normalized(view.up), back));
    *right = side;
    *up = vec3_normalized(vec3_cross(back, side));
    *forward = vec3_scaled(back, -1);
