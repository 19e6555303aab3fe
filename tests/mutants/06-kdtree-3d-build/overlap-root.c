// mutant: the distance is compared, whose root is rounded, and not its square
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: of a root, which is rounded
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    return sqrt(dx * dx + dy * dy + dz * dz) <= fabs((double)sphere.radius);
