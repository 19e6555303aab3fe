// mutant: minDepth starts with 0
// task: leaf_loop
// caught by: leaf-random
// says: starts too small
    float minDepth = 0.0f;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    for (uint i = 1; i <= n; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
