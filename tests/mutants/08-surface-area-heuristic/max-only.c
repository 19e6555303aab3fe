// mutant: as if every box began at 0
// task: surface_area
// caught by: area-boxes
// says: began at 0
    return 2.0 * ((double)box.max[0] * box.max[1] + (double)box.max[1] * box.max[2] +
                  (double)box.max[2] * box.max[0]);
