// mutant: the sample point is the pixel's centre instead of its integer coordinate
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: found [01], expected [01]
// looks: shifted-half
    const float dx = x + 0.5f - circle.x;
    const float dy = y + 0.5f - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth < minDepth;
