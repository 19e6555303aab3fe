// mutant: minDepth is lowered by circles that do not cover the pixel, too
// task: leaf_loop
// caught by: leaf-random
// says: do not cover
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    const uint first = offset + 1;
    float minDepth = INFINITY;
    for (uint i = 0; i < n; i++) {
        const Circle circle = circles[mapNode2Circles[first + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
        minDepth = fmin(minDepth, circle.depth);
    }
