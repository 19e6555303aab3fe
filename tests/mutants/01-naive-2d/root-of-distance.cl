// mutant: the root is taken, which is rounded
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: root
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return sqrt(dx * dx + dy * dy) <= circle.radius && circle.depth < minDepth;
