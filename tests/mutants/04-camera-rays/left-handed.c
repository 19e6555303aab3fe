// mutant: right is up x forward: it points to the left
// task: camera_axes
// caught by: axes-up
// says: left
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(view.up, *forward));
    *up = vec3_cross(*forward, *right);
