// mutant: a circle of radius 0 is taken for no circle
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: radius 0
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    if (circle.radius <= 0.0f) {
        return 0;
    }
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
