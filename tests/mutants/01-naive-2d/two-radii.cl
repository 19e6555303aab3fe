// mutant: the radius is doubled, not squared
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: 2 \* radius
    float dx = x - circle.x;
    float dy = y - circle.y;
    return dx * dx + dy * dy <= 2 * circle.radius && circle.depth < minDepth;
