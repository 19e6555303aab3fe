// mutant: t is not in the sum
// task: leave_surface
// caught by: leave-scale
// says: t is missing
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (fabs(radius) + largest) * normal;
