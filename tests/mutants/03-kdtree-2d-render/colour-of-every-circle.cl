// mutant: the answer of overlaps_N_Nearer is not used
// task: leaf_loop
// caught by: leaf-random
// says: whether or not it takes the pixel
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    for (uint i = 1; i <= n; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        overlaps_N_Nearer(x, y, circle, minDepth, &work);
        minDepth = circle.depth;
        color = (float4)(circle.r, circle.g, circle.b, circle.a);
    }
