// mutant: the background is opaque black, (0, 0, 0, 1)
// task: leaf_loop
// caught by: leaf-edges
// says: background
    color = (float4)(0.0f, 0.0f, 0.0f, 1.0f);
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
