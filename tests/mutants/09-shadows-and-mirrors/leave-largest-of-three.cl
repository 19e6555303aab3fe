// mutant: the largest of the three numbers, not their sum
// task: leave_surface
// caught by: leave-side
// says: not the largest
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * fmax(t, fmax(fabs(radius), largest)) * normal;
