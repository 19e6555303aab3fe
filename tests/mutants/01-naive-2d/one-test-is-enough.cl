// mutant: one of the two tests is enough
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: both have to hold
    float dx = x - circle.x;
    float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius || circle.depth < minDepth;
