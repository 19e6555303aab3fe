// mutant: the radius is not in the sum
// task: leave_surface
// caught by: leave-scale
// says: radius is missing
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + largest) * normal;
