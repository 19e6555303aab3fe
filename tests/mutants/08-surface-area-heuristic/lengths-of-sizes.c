// mutant: coordinates without their signs are subtracted
// task: surface_area
// caught by: area-boxes
// says: with their signs
    const double x = fabs((double)box.max[0]) - fabs((double)box.min[0]);
    const double y = fabs((double)box.max[1]) - fabs((double)box.min[1]);
    const double z = fabs((double)box.max[2]) - fabs((double)box.min[2]);
    return 2 * (fabs(x * y) + fabs(y * z) + fabs(z * x));
