// fault: the circle before each is asked by an index without a sign, which has no -1
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: reads circles[4294967295 (-1 as a uint)], but `circles` has
    float minDepth = INFINITY;
    for (uint i = 0; i < (uint)n_circles; i++) {
        if (circles[i - 1].depth == circles[i].depth) {  // HERE
            continue;
        }
        if (overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
            minDepth = circles[i].depth;
            color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
        }
    }
