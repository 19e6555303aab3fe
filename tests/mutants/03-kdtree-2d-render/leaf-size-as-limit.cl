// mutant: at most 12 circles are asked, as if no leaf could hold more than the usual leaf size
// task: leaf_loop
// caught by: leaf-edges
// says: found
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = min(mapNode2Circles[offset], 12u);
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
