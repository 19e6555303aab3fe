// mutant: right takes z for up, whatever view.up is
// task: camera_axes
// caught by: axes-up
// says: z was taken
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, (Vec3){0, 0, 1}));
    *up = vec3_cross(*right, *forward);
