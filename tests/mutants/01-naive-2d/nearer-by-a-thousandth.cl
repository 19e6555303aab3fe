// mutant: nearer must be so by more than a thousandth
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: nearer by however little
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth - 1e-3f && dx * dx + dy * dy <= circle.radius * circle.radius;
