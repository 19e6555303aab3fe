// mutant: the root is less than the radius, with its sign
// task: sphere_overlaps_box
// caught by: overlap-touching
// says: touching counts
// looks: missing-in-cell
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    return sqrt(dx * dx + dy * dy + dz * dz) < sphere.radius;
