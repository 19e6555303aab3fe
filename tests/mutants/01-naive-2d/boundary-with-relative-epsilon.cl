// mutant: a millionth of the radius is added, in case of rounding
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: no epsilon
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const float radius = circle.radius * 1.000001f;
    return circle.depth < minDepth && dx * dx + dy * dy <= radius * radius;
