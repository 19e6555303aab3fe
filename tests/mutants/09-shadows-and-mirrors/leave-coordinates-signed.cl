// mutant: negative coordinates are small
// task: leave_surface
// caught by: leave-scale
// says: their sizes the largest
    const float largest = fmax(fmax(point.x, point.y), point.z);
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
