// mutant: the distance on x is not squared
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: not the squares
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    const double r = sphere.radius;
    return !(dx + dy * dy + dz * dz > r * r);
