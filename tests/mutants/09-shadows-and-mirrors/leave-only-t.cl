// mutant: t alone
// task: leave_surface
// caught by: leave-scale
// says: only t counts
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * t * normal;
