// mutant: plus for minus in the way to the point
// task: camera_axes
// caught by: axes-forward
// says: minus .from., not plus
    *forward = vec3_normalized(vec3_plus(view.from, view.at));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*right, *forward);
