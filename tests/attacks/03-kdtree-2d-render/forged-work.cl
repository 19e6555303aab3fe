// attack: asks every circle of the scene, and writes a small number into the counted work
// task: leaf_loop
// named: a hand on the counted work
// score: 95
    float minDepth = INFINITY;
    for (uint i = 0; circles[i].depth > -1e8f; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
    work.n_tests = mapNode2Circles[nodes_Relations[id].circleMapOffset];
