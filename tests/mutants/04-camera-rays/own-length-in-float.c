// mutant: an own length in float: the squares leave float's range
// task: camera_axes
// caught by: axes-orthonormal
// says: leave float's range
    const Vec3 way = vec3_minus(view.at, view.from);
    *forward = vec3_scaled(way, 1 / sqrtf(vec3_dot(way, way)));
    const Vec3 side = vec3_cross(*forward, view.up);
    *right = vec3_scaled(side, 1 / sqrtf(vec3_dot(side, side)));
    *up = vec3_cross(*right, *forward);
