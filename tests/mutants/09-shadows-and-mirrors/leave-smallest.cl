// mutant: fmin for fmax
// task: leave_surface
// caught by: leave-scale
// says: not the smallest
    const float largest = fmin(fmin(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
