// mutant: the loop starts at 1
// task: implicit2DRenderer
// caught by: renderer-order
// says: first circle
    float minDepth = INFINITY;
    for (int i = 1; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
