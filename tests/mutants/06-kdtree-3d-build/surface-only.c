// mutant: a cell within the sphere does not count
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: lies within the sphere
// looks: missing-in-cell
    const double x = outside(sphere.x, box.min[0], box.max[0]),
                 y = outside(sphere.y, box.min[1], box.max[1]);
    const double z = outside(sphere.z, box.min[2], box.max[2]),
                 r2 = (double)sphere.radius * sphere.radius;
    const double fx =
        fmax(fabs((double)sphere.x - box.min[0]), fabs((double)sphere.x - box.max[0]));
    const double fy =
        fmax(fabs((double)sphere.y - box.min[1]), fabs((double)sphere.y - box.max[1]));
    const double fz =
        fmax(fabs((double)sphere.z - box.min[2]), fabs((double)sphere.z - box.max[2]));
    return x * x + y * y + z * z <= r2 && fx * fx + fy * fy + fz * fz >= r2;
