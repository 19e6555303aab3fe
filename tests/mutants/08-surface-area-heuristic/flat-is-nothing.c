// mutant: a box without volume is thought to have no area
// task: surface_area
// caught by: area-flat
// says: no volume, and still
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    if (x * y * z == 0) {
        return 0;
    }
    return 2 * (x * y + y * z + z * x);
