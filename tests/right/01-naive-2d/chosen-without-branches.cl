// right: no branch in the loop: the nearest circle's index and depth are selected
// task: implicit2DRenderer
    float minDepth = INFINITY;
    uint nearest = UINT_MAX;
    for (uint i = 0; i < (uint)n_circles; i++) {
        const int is_nearer = overlaps_N_Nearer(x, y, circles[i], minDepth, &work);
        minDepth = select(minDepth, circles[i].depth, is_nearer);
        nearest = select(nearest, i, (uint)is_nearer);
    }
    if (nearest != UINT_MAX) {
        const Circle circle = circles[nearest];
        color = (float4)(circle.r, circle.g, circle.b, circle.a);
    }
