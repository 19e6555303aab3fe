// mutant: a circle that covers the pixel is asked twice, once for each half of the question
// task: leaf_loop
// caught by: leaf-work
// says: more than once|asked twice
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (!overlaps_N_Nearer(x, y, circle, INFINITY, &work)) {
            continue;
        }
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
