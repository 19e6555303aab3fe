// mutant: equal depth counts as nearer: depth <= minDepth
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: found 1, expected 0
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth <= minDepth;
