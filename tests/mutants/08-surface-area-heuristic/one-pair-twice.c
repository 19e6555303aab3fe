// mutant: 2 multiplies one pair of faces only
// task: surface_area
// caught by: area-boxes
// says: one pair of faces
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return 2 * x * y + y * z + z * x;
