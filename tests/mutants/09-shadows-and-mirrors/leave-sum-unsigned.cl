// mutant: the size is that of t and the radius together
// task: leave_surface
// caught by: leave-side
// says: that of its sum
    const float3 size = fabs(point);
    const float largest = fmax(size.x, fmax(size.y, size.z));
    const float distance = SURFACE_ERROR * (fabs(t + radius) + largest);
    return point + distance * normal;
