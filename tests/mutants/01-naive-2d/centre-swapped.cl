// mutant: the centre's x and y are swapped
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: compared with the centre's y
    float dx = x - circle.y;
    float dy = y - circle.x;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth < minDepth;
