// mutant: the loop ends at depth 0
// task: leaf_loop
// caught by: leaf-edges
// says: negative
    global const uint *list = mapNode2Circles + nodes_Relations[id].circleMapOffset;
    float minDepth = INFINITY;
    for (uint i = 1; i <= list[0]; i++) {
        const Circle c = circles[list[i]];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
        if (minDepth <= 0.0f)
            break;
    }
