// mutant: dx and dy are whole numbers: their fraction is lost
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: whole-numbered
    const int dx = x - circle.x;
    const int dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
