// mutant: forward goes from the point looked at to the eye
// task: camera_axes
// caught by: axes-up
// says: right comes from forward
    *forward = vec3_normalized(vec3_minus(view.from, view.at));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*right, *forward);
