// mutant: away from the scene's origin, not from the ball
// task: leave_surface
// caught by: leave-side
// says: beside it
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normalize(point);
