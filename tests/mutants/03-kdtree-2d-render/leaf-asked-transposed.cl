// mutant: x and y change places in the call of overlaps_N_Nearer
// task: leaf_loop
// caught by: leaf-random
// says: rows and columns were swapped
// looks: transposed
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    for (uint i = 1; i <= mapNode2Circles[offset]; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(y, x, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
