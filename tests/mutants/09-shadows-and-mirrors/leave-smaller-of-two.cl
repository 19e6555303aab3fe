// mutant: of x and y the smaller one counts
// task: leave_surface
// caught by: leave-side
// says: another number
    const float3 size = fabs(point);
    const float some = fmax(fmin(size.x, size.y), size.z);
    return point + normal * (SURFACE_ERROR * (t + fabs(radius) + some));
