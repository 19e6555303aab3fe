// mutant: the squared distance is kept in an int
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: cut to a whole number
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const int d2 = dx * dx + dy * dy;
    return d2 <= circle.radius * circle.radius && circle.depth < minDepth;
