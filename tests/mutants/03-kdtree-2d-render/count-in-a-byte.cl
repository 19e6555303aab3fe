// mutant: the count of a list is kept in a byte
// task: leaf_loop
// caught by: leaf-work
// says: 8 bits
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uchar n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
