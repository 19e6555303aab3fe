// mutant: one pixel of the widest picture is never covered
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: pixel \(316, 99\)
    if (x == 316 && y == 99) {
        return 0;
    }
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
