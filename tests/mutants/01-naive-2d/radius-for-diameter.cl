// mutant: the radius is taken for the diameter
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: half the radius
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const float radius = circle.radius / 2;
    return dx * dx + dy * dy <= radius * radius && circle.depth < minDepth;
