// mutant: the channels are written as blue, green, red
// task: leaf_loop
// caught by: leaf-random
// says: red and blue swapped
// looks: channels-swapped
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.b, circle.g, circle.r, circle.a);
        }
    }
