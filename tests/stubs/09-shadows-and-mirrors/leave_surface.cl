    // High above the surface.
    return point + 0.125f * fabs(radius) * normal;
