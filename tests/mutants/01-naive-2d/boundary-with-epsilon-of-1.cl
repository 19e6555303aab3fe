// mutant: an epsilon of 1 is added
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: no epsilon
    float dx = x - circle.x, dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius + 1 && circle.depth < minDepth;
