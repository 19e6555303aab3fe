// right: the point's distance from the origin, which is no less than its largest coordinate
// task: leave_surface
    const float reach = t + fabs(radius) + length(point);
    return point + (SURFACE_ERROR * reach) * normal;
