// right: both comparisons as differences
// task: overlaps_N_Nearer
    const float2 d = {x - circle.x, y - circle.y};
    const float inside = circle.radius * circle.radius - d.x * d.x - d.y * d.y;
    return minDepth - circle.depth > 0.0f && inside >= 0.0f;
