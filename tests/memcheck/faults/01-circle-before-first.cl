// fault: the circle before each is asked, also before the first one
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: reads circles[-1], but `circles` has
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        if (circles[i - 1].depth == circles[i].depth) {  // HERE
            continue;
        }
        if (overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
            minDepth = circles[i].depth;
            color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
        }
    }
