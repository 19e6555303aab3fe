// mutant: the position in the list is taken for the circle id
// task: leaf_loop
// caught by: leaf-random
// says: position in the list
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[i - 1];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
