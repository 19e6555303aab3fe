// mutant: a hundredth is added, in case of rounding
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: no epsilon
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const float distance2 = dx * dx + dy * dy;
    return circle.depth < minDepth && distance2 <= circle.radius * circle.radius + 0.01f;
