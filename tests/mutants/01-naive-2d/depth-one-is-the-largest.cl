// mutant: takes 1 for the largest depth
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: largest depth of 1
    float dx = x - circle.x, dy = y - circle.y;
    float limit = fmin(minDepth, 1.0f);
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth < limit;
