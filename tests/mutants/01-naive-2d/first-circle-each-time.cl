// mutant: the loop asks circle 0 each time
// task: implicit2DRenderer
// caught by: renderer-random
// says: only the first circle|nothing but the background
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[0];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
