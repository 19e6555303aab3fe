// mutant: a flat box's face counts once
// task: surface_area
// caught by: area-flat
// says: both count
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    const int flat = x == 0 || y == 0 || z == 0;
    return (flat ? 1 : 2) * (x * y + y * z + z * x);
