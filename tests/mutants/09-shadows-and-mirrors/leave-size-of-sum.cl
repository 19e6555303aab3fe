// mutant: the size of the sum of the coordinates
// task: leave_surface
// caught by: leave-scale
// says: size of their sum
    return point + SURFACE_ERROR * (t + fabs(radius) + fabs(point.x + point.y + point.z)) * normal;
