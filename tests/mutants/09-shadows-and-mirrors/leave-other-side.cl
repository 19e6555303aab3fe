// mutant: against the normal, into the ball
// task: leave_surface
// caught by: leave-side
// says: to the other side
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point - SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
