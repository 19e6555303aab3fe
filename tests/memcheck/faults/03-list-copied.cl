// fault: the leaf's list is copied to an array that is too short for it
// lab: 03-kdtree-2d-render
// task: leaf_loop
// says: writes outside of an array
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    uint ids[4];
    for (uint i = 0; i < n_circles; i++) {
        ids[i] = mapNode2Circles[offset + 1 + i];  // HERE
    }
    for (uint i = 0; i < n_circles; i++) {
        const Circle circle = circles[ids[i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
