// mutant: the squares of y and z are taken off
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: square was subtracted
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    const double r = sphere.radius;
    return r * r >= dx * dx - dy * dy - dz * dz;
