// right: fused multiply-add, and the sign of the difference
// task: overlaps_N_Nearer
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    const float beyond = fma(dx, dx, fma(dy, dy, -circle.radius * circle.radius));
    return !(beyond > 0.0f || circle.depth >= minDepth);
