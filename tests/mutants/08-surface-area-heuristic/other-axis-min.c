// mutant: the third length begins at the lowest y
// task: surface_area
// caught by: area-boxes
// says: of another axis
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[1];
    return 2 * (x * y + y * z + z * x);
