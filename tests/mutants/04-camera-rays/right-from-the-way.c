// mutant: right from the way before it is a unit vector: its product leaves float's range
// task: camera_axes
// caught by: axes-orthonormal
// says: leave float's range
    const Vec3 way = vec3_minus(view.at, view.from);
    *forward = vec3_normalized(way);
    *right = vec3_normalized(vec3_cross(way, view.up));
    *up = vec3_cross(*right, *forward);
