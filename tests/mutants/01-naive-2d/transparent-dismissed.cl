// mutant: circles that nobody sees are left out
// task: implicit2DRenderer
// caught by: renderer-edges
// says: transparent circles
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (circle.a > 0.0f && overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
