// mutant: right is not made a unit vector, up is
// task: camera_axes
// caught by: axes-orthonormal
// says: right is not made
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_cross(*forward, view.up);
    *up = vec3_normalized(vec3_cross(*right, *forward));
