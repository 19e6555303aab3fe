// mutant: the first circle of the list is taken for the count: the loop starts at 2
// task: leaf_loop
// caught by: leaf-random
// says: first circle of every leaf
// looks: missing-in-cell
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 2; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
