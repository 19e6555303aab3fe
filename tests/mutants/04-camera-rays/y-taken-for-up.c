// mutant: up is always y
// task: camera_axes
// caught by: axes-up
// says: view.up is not asked
    const Vec3 above = {0, 1, 0};
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, above));
    *up = vec3_cross(*right, *forward);
