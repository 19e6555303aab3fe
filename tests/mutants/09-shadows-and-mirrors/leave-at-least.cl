// mutant: at least a ten-thousandth
// task: leave_surface
// caught by: leave-side
// says: never less than a fixed distance
    const float3 size = fabs(point);
    const float largest = fmax(size.x, fmax(size.y, size.z));
    const float distance = fmax(1e-4f, SURFACE_ERROR * (t + fabs(radius) + largest));
    return point + distance * normal;
