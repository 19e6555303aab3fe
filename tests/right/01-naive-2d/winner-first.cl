// right: the nearest circle's index first, its colour at the end
// task: implicit2DRenderer
    int nearest = -1;
    float minDepth = FLT_MAX;
    if (n_circles > 0) {
        minDepth = INFINITY;
    }
    for (int i = 0; i != n_circles; ++i) {
        if (overlaps_N_Nearer(x, y, circles[i], minDepth, &work) != 0) {
            nearest = i;
            minDepth = circles[nearest].depth;
        }
    }
    if (nearest >= 0) {
        color = (float4)(circles[nearest].r, circles[nearest].g, circles[nearest].b,
                         circles[nearest].a);
    }
