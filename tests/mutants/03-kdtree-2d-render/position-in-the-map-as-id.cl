// mutant: the position in mapNode2Circles is taken for the circle id
// task: leaf_loop
// caught by: leaf-random
// says: position in the list
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    for (uint i = 1; i <= n; i++) {
        const Circle circle = circles[offset + i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
