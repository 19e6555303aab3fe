// mutant: a depth has to be from 0 to 1
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: outside of 0 to 1
    if (circle.depth < 0.0f || circle.depth > 1.0f || circle.depth >= minDepth) {
        return 0;
    }
    const float dx = x - circle.x, dy = y - circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius;
