// mutant: circle 0 is taken for none
// task: leaf_loop
// caught by: leaf-random
// says: circle 0 were none
    const uint offset = nodes_Relations[id].circleMapOffset;
    float minDepth = INFINITY;
    uint nearest = 0;
    for (uint i = 1; i <= mapNode2Circles[offset]; i++) {
        const uint circle = mapNode2Circles[offset + i];
        if (overlaps_N_Nearer(x, y, circles[circle], minDepth, &work)) {
            nearest = circle;
            minDepth = circles[circle].depth;
        }
    }
    if (nearest)
        color = (float4)(circles[nearest].r, circles[nearest].g, circles[nearest].b, circles[nearest].a);
