// right: a pointer into the list, and what is left is counted down
// task: leaf_loop
    float minDepth = INFINITY;
    global const uint *list = mapNode2Circles + nodes_Relations[id].circleMapOffset;
    uint n_left = *list++;
    while (n_left-- > 0) {
        const Circle asked = circles[*list++];
        if (overlaps_N_Nearer(x, y, asked, minDepth, &work)) {
            color = (float4)(asked.r, asked.g, asked.b, asked.a);
            minDepth = asked.depth;
        }
    }
