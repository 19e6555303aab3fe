// mutant: the greatest depth is kept instead of the smallest
// task: leaf_loop
// caught by: leaf-random
// says: farthest
    float maxDepth = -INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, INFINITY, &work) && circle.depth > maxDepth) {
            maxDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
