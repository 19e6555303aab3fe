// mutant: the rows have no part in the distance
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: one axis alone
    const float dx = fabs(x - circle.x);
    (void)y;
    return circle.depth < minDepth && dx <= circle.radius;
