// mutant: six times the face of x and y
// task: surface_area
// caught by: area-boxes
// says: six times one of the faces
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    (void)z;
    return 6 * x * y;
