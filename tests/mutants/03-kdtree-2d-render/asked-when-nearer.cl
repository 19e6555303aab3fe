// mutant: does not ask circles that are not nearer
// task: leaf_loop
// caught by: leaf-work
// says: not asked
    const uint first = nodes_Relations[id].circleMapOffset + 1, n = mapNode2Circles[first - 1];
    float minDepth = INFINITY;
    for (uint i = first; i < first + n; i++) {
        const Circle c = circles[mapNode2Circles[i]];
        if (c.depth >= minDepth)
            continue;
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
