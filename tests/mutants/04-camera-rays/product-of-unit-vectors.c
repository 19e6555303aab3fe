// mutant: the product of two unit vectors is taken for one
// task: camera_axes
// caught by: axes-orthonormal
// says: shorter than 1
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_cross(*forward, vec3_normalized(view.up));
    *up = vec3_cross(*right, *forward);
