// mutant: dy times dx in the place of a square
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: multiplied by that on another
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    return dx * dx + dy * dx + dz * dz <= (double)sphere.radius * sphere.radius;
