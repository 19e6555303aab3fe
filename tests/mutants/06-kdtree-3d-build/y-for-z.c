// mutant: the centre's y for its z
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: numbers of another
// looks: missing-in-cell
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.y, box.min[2], box.max[2]);
    const double r = sphere.radius;
    return dx * dx + dy * dy + dz * dz <= r * r;
