// mutant: on y maximum and minimum are added
// task: surface_area
// caught by: area-boxes
// says: one length is not
    const double x = (double)box.max[0] - box.min[0], y = (double)box.max[1] + box.min[1],
                 z = (double)box.max[2] - box.min[2];
    return (x * y + x * z + y * z) * 2;
