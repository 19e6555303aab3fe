// mutant: |dx| + |dy| is taken for the distance
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: \|dx\| \+ \|dy\|
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return fabs(dx) + fabs(dy) <= circle.radius && circle.depth < minDepth;
