// right: the distance itself, its root in double
// task: sphere_overlaps_box
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    return sqrt(dz * dz + (dy * dy + dx * dx)) <= fabs((double)sphere.radius);
