// mutant: the part along the way, not along forward, is taken from up
// task: camera_axes
// caught by: axes-orthonormal
// says: not yet a unit vector
    const Vec3 d = vec3_minus(view.at, view.from);
    *forward = vec3_normalized(d);
    *up = vec3_normalized(vec3_minus(view.up, vec3_scaled(*forward, vec3_dot(view.up, d))));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
