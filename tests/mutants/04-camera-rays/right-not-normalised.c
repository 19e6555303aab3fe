// mutant: right is as long as the cross product
// task: camera_axes
// caught by: axes-orthonormal
// says: right is not made
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_cross(*forward, view.up);
    *up = vec3_cross(*right, *forward);
