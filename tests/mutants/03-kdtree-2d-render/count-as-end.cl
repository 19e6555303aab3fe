// mutant: the list ends at the position that its count names
// task: leaf_loop
// caught by: leaf-random
// says: position at which its list ends
// never says: &work|were not asked
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = offset + 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
