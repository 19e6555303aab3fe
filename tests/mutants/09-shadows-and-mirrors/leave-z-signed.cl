// mutant: no size of z
// task: leave_surface
// caught by: leave-scale
// says: may be negative
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), point.z);
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
