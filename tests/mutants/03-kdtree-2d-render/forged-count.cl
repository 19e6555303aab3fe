// mutant: tests and counts by itself instead of calling
// task: leaf_loop
// caught by: leaf-work
// says: without a call
    const uint first = nodes_Relations[id].circleMapOffset + 1, n = mapNode2Circles[first - 1];
    float minDepth = INFINITY;
    for (uint i = first; i < first + n; i++) {
        const Circle c = circles[mapNode2Circles[i]];
        const float dx = x - c.x, dy = y - c.y;
        work.n_tests++;
        if (c.depth < minDepth && dx * dx + dy * dy <= c.radius * c.radius) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
