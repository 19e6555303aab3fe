// mutant: the three sizes are multiplied
// task: leave_surface
// caught by: leave-side
// says: multiplied
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * t * fabs(radius) * largest * normal;
