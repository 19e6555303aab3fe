// fault: the next id is read ahead of its turn, also behind the last list
// lab: 03-kdtree-2d-render
// task: leaf_loop
// says: reads mapNode2Circles[
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    uint next = offset;
    for (uint i = 1; i <= n_circles; i++) {
        const uint circle_id = mapNode2Circles[offset + i];
        next = mapNode2Circles[offset + i + 1];  // HERE
        const Circle circle = circles[circle_id];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
