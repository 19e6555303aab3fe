// mutant: an epsilon is added, in case of rounding
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: no epsilon
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy - circle.radius * circle.radius < 1e-6f;
