// right: in the plane of axis and centre
// task: cone_misses_sphere
    const float2 border = {cone.cosine, cone.sine};
    const float2 at = {dot(centre, cone.axis),
                       length(centre - dot(centre, cone.axis) * cone.axis)};
    // The cross product is the distance from the border's line.
    return border.x * at.y - border.y * at.x > max(radius, -radius);
