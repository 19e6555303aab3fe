// mutant: a slip of the pen: dx² + dx² instead of dx² + dy²
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: dx² \+ dx²
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    (void)dy;
    return dx * dx + dx * dx <= circle.radius * circle.radius && circle.depth < minDepth;
