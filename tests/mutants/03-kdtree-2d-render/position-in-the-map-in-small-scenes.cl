// mutant: the same in small scenes, which may not show it: then nothing is said
// task: leaf_loop
// caught by: leaf-edges
// says: position in the list|pixels differ\)$
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
