// mutant: the centre's fraction is cut off
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: whole-numbered
    int dx = x - (int)circle.x;
    int dy = y - (int)circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth < minDepth;
