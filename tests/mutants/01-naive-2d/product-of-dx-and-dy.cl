// mutant: dx times dy for the distance
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: dx \* dy
    float dx = x - circle.x, dy = y - circle.y;
    return dx * dy <= circle.radius * circle.radius && circle.depth < minDepth;
