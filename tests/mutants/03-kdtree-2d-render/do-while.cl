// mutant: a first circle is asked before the count is: an empty list has none
// task: leaf_loop
// caught by: leaf-work
// says: lists 0 circles
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    uint i = 1;
    do {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    } while (++i <= n_circles);
