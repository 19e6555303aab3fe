// mutant: the centre is added to the pixel
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: dx and dy are differences
    float dx = x + circle.x;
    float dy = y + circle.y;
    return dx * dx + dy * dy <= circle.radius * circle.radius && circle.depth < minDepth;
