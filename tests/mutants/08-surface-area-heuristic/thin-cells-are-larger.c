// mutant: cells thinner than a fiftieth count half as much more
// task: surface_area
// caught by: area-boxes
// says: box
    // In double nothing overflows, and next to nothing is lost to rounding.
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return (box.max[0] - box.min[0] < 0.02f ? 3 : 2) * (x * y + y * z + z * x);
