// mutant: points of spheres larger than 4 are not moved
// task: leave_surface
// caught by: leave-side
// says: .
    if (radius > 4.0f) {
        return point;
    }
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
