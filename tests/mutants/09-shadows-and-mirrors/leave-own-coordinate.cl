// mutant: each coordinate moves by its own size
// task: leave_surface
// caught by: leave-scale
// says: by its own size
    const float3 distance = SURFACE_ERROR * (t + fabs(radius) + fabs(point));
    return point + distance * normal;
