// mutant: another up where the view looks nearly along it
// task: camera_axes
// caught by: axes-up
// says: however small
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    Vec3 upwards = vec3_normalized(view.up);
    if (fabsf(vec3_dot(*forward, upwards)) > 0.99f) {
        upwards = (Vec3){1, 0, 0};
    }
    *right = vec3_normalized(vec3_cross(*forward, upwards));
    *up = vec3_cross(*right, *forward);
