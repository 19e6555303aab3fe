// mutant: a circle with a negative depth is taken to be behind the viewer
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: found 0, expected 1
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth >= 0 &&
           circle.depth < minDepth;
