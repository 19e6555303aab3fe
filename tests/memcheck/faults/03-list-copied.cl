// fault: the leaf's list is copied to an array that is too short for it
// lab: 03-kdtree-2d-render
// task: leaf_loop
// says: uses index 4 of an array of 4 entries, 0 to 3
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
