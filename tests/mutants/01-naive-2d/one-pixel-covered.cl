// mutant: one pixel is always covered
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: pixel \(7, 7\)
    if (x == 7 && y == 7) {
        return 1;
    }
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
