// mutant: the square of a radius of 46341 and more does not fit an int
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: radius
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const int inside = circle.radius < 46341 ? dx * dx + dy * dy <= circle.radius * circle.radius : 0;
    return circle.depth < minDepth && inside;
