// mutant: the circle is taken to be twice as large
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: twice the radius
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const float diameter = 2 * circle.radius;
    return circle.depth < minDepth && dx * dx + dy * dy <= diameter * diameter;
