// mutant: 16 bits are to hold a circle's id
// task: leaf_loop
// caught by: leaf-edges
// says: found
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const ushort circle_id = mapNode2Circles[offset + i];
        const Circle circle = circles[circle_id];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
