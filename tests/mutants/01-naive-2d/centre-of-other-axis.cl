// mutant: a slip of the pen: dx takes the centre's y
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: x and y are mixed up
    const float dx = x - circle.y;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
