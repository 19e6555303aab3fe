// mutant: equal depth counts as nearer: depth <= minDepth
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: nearer is strict|equal depth
// looks: later-of-equals
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth <= minDepth;
