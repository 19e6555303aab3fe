// mutant: a sphere without a positive radius overlaps nothing
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: is a point
// looks: missing-in-cell
    if (!(sphere.radius > 0)) {
        return 0;
    }
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    return dx * dx + dy * dy + dz * dz <= (double)sphere.radius * sphere.radius;
