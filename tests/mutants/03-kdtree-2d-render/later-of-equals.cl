// mutant: of two equal depths the later circle wins: depth <= minDepth in a test of its own
// task: leaf_loop
// caught by: leaf-order
// says: equal depth
// looks: later-of-equals
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, INFINITY, &work) && circle.depth <= minDepth) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
