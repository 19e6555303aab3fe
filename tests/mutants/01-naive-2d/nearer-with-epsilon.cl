// mutant: depths that are nearly equal count as nearer
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: farther by however little
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth <= minDepth + 1e-5f && dx * dx + dy * dy <= circle.radius * circle.radius;
