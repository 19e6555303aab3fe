// mutant: the depth test is the wrong way round: the farther circle counts as nearer
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: found [01], expected [01]
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth > minDepth;
