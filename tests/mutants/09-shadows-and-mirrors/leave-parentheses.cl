// mutant: no parentheses around the sum
// task: leave_surface
// caught by: leave-side
// says: parentheses
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + (SURFACE_ERROR * t + fabs(radius) + largest) * normal;
