// mutant: forward is the point looked at, as if the eye were at the origin
// task: camera_axes
// caught by: axes-forward
// says: from the origin, not
    *forward = vec3_normalized(view.at);
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*right, *forward);
