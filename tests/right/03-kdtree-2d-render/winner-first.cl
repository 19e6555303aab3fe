// right: the nearest circle's id first, its colour at the end
// task: leaf_loop
    const uint first = nodes_Relations[id].circleMapOffset + 1;
    const uint end = first + mapNode2Circles[first - 1];
    float minDepth = INFINITY;
    uint nearest = UINT_MAX;
    for (uint i = first; i < end; i++) {
        const uint circle_id = mapNode2Circles[i];
        if (overlaps_N_Nearer(x, y, circles[circle_id], minDepth, &work)) {
            minDepth = circles[circle_id].depth;
            nearest = circle_id;
        }
    }
    if (nearest != UINT_MAX) {
        const Circle winner = circles[nearest];
        color = (float4)(winner.r, winner.g, winner.b, winner.a);
    }
