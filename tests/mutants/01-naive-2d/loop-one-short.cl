// mutant: the loop ends one circle early
// task: implicit2DRenderer
// caught by: renderer-edges
// says: last circle
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles - 1; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
