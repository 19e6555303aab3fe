// mutant: depths are compared as whole numbers
// task: overlaps_N_Nearer
// caught by: overlaps-nearer
// says: whole numbers
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const int nearest = (int)minDepth;
    return (int)circle.depth < nearest && dx * dx + dy * dy <= circle.radius * circle.radius;
