// mutant: minDepth starts with 1/2
// task: implicit2DRenderer
// caught by: renderer-random
// says: minDepth starts too small
    float minDepth = 0.5f;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
