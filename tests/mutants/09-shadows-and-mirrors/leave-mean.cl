// mutant: the mean of the coordinates' sizes
// task: leave_surface
// caught by: leave-scale
// says: not their mean
    const float3 size = fabs(point);
    const float largest = (size.x + size.y + size.z) / 3.0f;
    const float distance = SURFACE_ERROR * (t + fabs(radius) + largest);
    return point + distance * normal;
