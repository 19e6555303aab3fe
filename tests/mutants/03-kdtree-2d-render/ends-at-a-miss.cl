// mutant: the loop ends at the first circle that does not take the pixel
// task: leaf_loop
// caught by: leaf-random
// says: first circle that does not take the pixel
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    for (uint i = 1; i <= n; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (!overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            break;
        }
        minDepth = circle.depth;
        color = (float4)(circle.r, circle.g, circle.b, circle.a);
    }
