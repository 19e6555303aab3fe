// mutant: the radius is taken off
// task: leave_surface
// caught by: leave-side
// says: taken off
    const float3 size = fabs(point);
    const float largest = fmax(size.x, fmax(size.y, size.z));
    const float offset = SURFACE_ERROR * (t + largest - fabs(radius));
    return point + offset * normal;
