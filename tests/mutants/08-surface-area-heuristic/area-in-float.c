// mutant: multiplied in float, which overflows
// task: surface_area
// caught by: area-flat
// says: overflows
    const float x = box.max[0] - box.min[0];
    const float y = box.max[1] - box.min[1];
    const float z = box.max[2] - box.min[2];
    return 2 * (x * (y + z) + y * z);
