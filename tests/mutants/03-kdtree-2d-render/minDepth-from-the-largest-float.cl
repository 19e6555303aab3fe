// mutant: minDepth starts with FLT_MAX, which a depth may be
// task: leaf_loop
// caught by: leaf-edges
// says: starts too small
    global const uint *list = mapNode2Circles + nodes_Relations[id].circleMapOffset;
    float minDepth = FLT_MAX;
    for (uint i = 1; i <= list[0]; i++) {
        const Circle c = circles[list[i]];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
