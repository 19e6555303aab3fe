// mutant: minDepth starts at 1, as if depths ended there
// task: implicit2DRenderer
// caught by: renderer-random
// says: found
    float minDepth = 1.0f;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
