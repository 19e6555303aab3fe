// mutant: a short forward is not made a unit vector
// task: camera_axes
// caught by: axes-forward
// says: any length counts
    const Vec3 way = vec3_minus(view.at, view.from);
    *forward = vec3_length(way) > 1e-6 ? vec3_normalized(way) : (Vec3){0, 0, -1};
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*right, *forward);
