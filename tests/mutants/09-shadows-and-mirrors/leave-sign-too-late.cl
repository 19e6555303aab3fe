// mutant: the largest coordinate is chosen before its size is taken
// task: leave_surface
// caught by: leave-scale
// says: their sizes the largest
    const float3 size = point;
    const float largest = fabs(fmax(size.x, fmax(size.y, size.z)));
    const float distance = SURFACE_ERROR * (t + fabs(radius) + largest);
    return point + distance * normal;
