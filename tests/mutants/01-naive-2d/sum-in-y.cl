// mutant: plus for minus in one of the differences
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: pixel plus centre
    const float2 d = (float2)(x - circle.x, y + circle.y);
    return circle.depth < minDepth && dot(d, d) <= circle.radius * circle.radius;
