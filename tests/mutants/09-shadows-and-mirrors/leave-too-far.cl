// mutant: a thousand times as far as needed
// task: leave_surface
// caught by: leave-side
// says: farther than needed
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + 1000.0f * SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
