// mutant: only x and y are looked at
// task: leave_surface
// caught by: leave-scale
// says: z is not looked at
    const float3 size = fabs(point);
    const float largest = fmax(size.x, size.y);
    const float distance = SURFACE_ERROR * (t + fabs(radius) + largest);
    return point + distance * normal;
