// mutant: the circle's bounding square is tested instead of the circle
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: bounding square
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return fabs(dx) <= circle.radius && fabs(dy) <= circle.radius && circle.depth < minDepth;
