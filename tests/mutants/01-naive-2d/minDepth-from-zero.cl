// mutant: minDepth starts with 0: nothing is nearer
// task: implicit2DRenderer
// caught by: renderer-random
// says: empty|starts too small
    float minDepth = 0.0f;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
