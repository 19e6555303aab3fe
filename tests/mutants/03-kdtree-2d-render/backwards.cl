// mutant: the list is walked through from its end, so the later of two equals is kept
// task: leaf_loop
// caught by: leaf-order
// says: equal depth
// looks: later-of-equals
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = n_circles; i >= 1; i--) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
