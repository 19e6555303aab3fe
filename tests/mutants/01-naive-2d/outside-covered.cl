// mutant: the distance is compared the wrong way round
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: covers what is outside
    float dx = x - circle.x;
    float dy = y - circle.y;
    return dx * dx + dy * dy >= circle.radius * circle.radius && circle.depth < minDepth;
