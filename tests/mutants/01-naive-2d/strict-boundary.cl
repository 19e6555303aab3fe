// mutant: the boundary is left out: distance² < radius²
// task: overlaps_N_Nearer
// caught by: overlaps-boundary
// says: strict
// looks: strict-boundary
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return dx * dx + dy * dy < circle.radius * circle.radius && circle.depth < minDepth;
