// mutant: lengths cut to whole numbers
// task: surface_area
// caught by: area-boxes
// says: whole numbers
    const int x = (int)(box.max[0] - box.min[0]);
    const int y = (int)(box.max[1] - box.min[1]);
    const int z = (int)(box.max[2] - box.min[2]);
    return 2.0 * ((double)x * y + (double)y * z + (double)z * x);
