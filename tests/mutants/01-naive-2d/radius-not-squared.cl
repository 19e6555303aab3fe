// mutant: the squared distance is compared with the radius itself
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: without its square
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius && circle.depth < minDepth;
