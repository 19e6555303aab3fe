// mutant: an empty list is read, too: the circle behind the end of the array is drawn
// task: leaf_loop
// caught by: leaf-edges
// says: one circle too many
    uint pos = nodes_Relations[id].circleMapOffset;
    const uint n = mapNode2Circles[pos];
    float minDepth = INFINITY;
    uint i = 0;
    do {
        pos++;
        const Circle circle = circles[mapNode2Circles[pos]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
        i++;
    } while (i < n);
