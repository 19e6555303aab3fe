// mutant: up is forward x right: it points down
// task: camera_axes
// caught by: axes-up
// says: down
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*forward, *right);
