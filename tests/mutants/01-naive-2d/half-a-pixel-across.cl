// mutant: half a pixel is added to x only
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: in one direction
// looks: shifted-half
    const float dx = x + 0.5f - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
