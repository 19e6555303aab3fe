// mutant: a negative radius shortens the sum
// task: leave_surface
// caught by: leave-side
// says: its size is added
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + radius + largest) * normal;
