// right: each coordinate for itself, with mad()
// task: leave_surface
    float largest = fabs(point.x);
    largest = fabs(point.y) > largest ? fabs(point.y) : largest;
    largest = fabs(point.z) > largest ? fabs(point.z) : largest;
    const float reach = 1.5f * SURFACE_ERROR * (t + (radius < 0.0f ? -radius : radius) + largest);
    return mad(reach, normal, point);
