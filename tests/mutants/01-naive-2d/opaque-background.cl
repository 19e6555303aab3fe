// mutant: the background is opaque black, (0, 0, 0, 1)
// task: implicit2DRenderer
// caught by: renderer-edges
// says: background
    color = (float4)(0.0f, 0.0f, 0.0f, 1.0f);
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
