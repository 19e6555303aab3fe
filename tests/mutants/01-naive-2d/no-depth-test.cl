// mutant: the depth test is missing
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: found 1, expected 0
    (void)minDepth;
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius;
