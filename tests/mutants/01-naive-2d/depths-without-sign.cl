// mutant: depths are compared without their sign
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: without their sign
    float dx = x - circle.x;
    float dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && fabs(circle.depth) < fabs(minDepth);
