// mutant: where the leaf has no circles nothing is written, not even the background
// task: leaf_loop
// caught by: leaf-edges
// says: nobody wrote
// looks: unwritten
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    if (n_circles == 0) {
        return;
    }
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
