// mutant: the colour is set outside of the if
// task: implicit2DRenderer
// caught by: renderer-random
// says: whether or not it takes the pixel
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        if (overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
            minDepth = circles[i].depth;
        }
        color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
    }
