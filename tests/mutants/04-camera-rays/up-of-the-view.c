// mutant: up is view.up, made a unit vector but not orthogonal
// task: camera_axes
// caught by: axes-orthonormal
// says: up is view.up
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_normalized(view.up);
