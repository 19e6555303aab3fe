// mutant: == for <= between the squares
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: the boundary alone
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy == circle.radius * circle.radius;
