// mutant: the squares are subtracted
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: the squares are added
    float dx = x - circle.x;
    float dy = y - circle.y;
    return (dx * dx - dy * dy) <= circle.radius * circle.radius && circle.depth < minDepth;
