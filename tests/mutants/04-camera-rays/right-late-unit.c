// mutant: right becomes a unit vector only after up came from it
// task: camera_axes
// caught by: axes-orthonormal
// says: only after up
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_cross(*forward, view.up);
    *up = vec3_cross(*right, *forward);
    *right = vec3_normalized(*right);
