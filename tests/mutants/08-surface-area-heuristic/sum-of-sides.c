// mutant: the three lengths
// task: surface_area
// caught by: area-boxes
// says: three lengths
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return x + y + z;
