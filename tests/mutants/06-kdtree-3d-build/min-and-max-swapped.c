// mutant: minimum and maximum are swapped
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: one corner
// looks: missing-in-cell
    const double dx = outside(sphere.x, box.max[0], box.min[0]);
    const double dy = outside(sphere.y, box.max[1], box.min[1]);
    const double dz = outside(sphere.z, box.max[2], box.min[2]);
    const double r = sphere.radius;
    return dx * dx + dy * dy + dz * dz <= r * r;
