// mutant: subtracted in float, which overflows
// task: surface_area
// caught by: area-flat
// says: overflows
    const double x = box.max[0] - box.min[0];
    const double y = box.max[1] - box.min[1];
    const double z = box.max[2] - box.min[2];
    return 2 * (x * y + y * z + z * x);
