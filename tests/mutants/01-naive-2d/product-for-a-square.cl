// mutant: dx * dy in the place of dy²
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: in the place of a square
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * (dx + dy) <= circle.radius * circle.radius;
