// mutant: forward keeps the length of the way
// task: camera_axes
// caught by: axes-orthonormal
// says: forward is not made a unit vector
    const Vec3 way = vec3_minus(view.at, view.from);
    *forward = way;
    *right = vec3_normalized(vec3_cross(way, view.up));
    *up = vec3_normalized(vec3_cross(*right, way));
