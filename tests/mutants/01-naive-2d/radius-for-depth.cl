// mutant: the radius is compared with minDepth
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: not its depth
    const float dx = x - circle.x, dy = y - circle.y;
    return minDepth > circle.radius && dx * dx + dy * dy <= circle.radius * circle.radius;
