// right: three early outs: the depth, the bounding square, the circle
// task: overlaps_N_Nearer
    if (!(circle.depth < minDepth)) {
        return 0;
    }
    const float dx = fabs(x - circle.x);
    const float dy = fabs(y - circle.y);
    if (dx > circle.radius || dy > circle.radius) {
        return 0;
    }
    return circle.radius * circle.radius - dx * dx >= dy * dy ? 1 : 0;
