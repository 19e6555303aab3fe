// mutant: the entry behind the end of the list is read, too
// task: leaf_loop
// caught by: leaf-edges
// says: one circle too many
// never says: asked twice
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[offset];
    for (uint i = 0; i <= n; i++) {
        const Circle circle = circles[mapNode2Circles[offset + 1 + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
