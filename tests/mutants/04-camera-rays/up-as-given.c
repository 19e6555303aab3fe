// mutant: up is view.up as it is
// task: camera_axes
// caught by: axes-orthonormal
// says: up is view.up
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = view.up;
