// mutant: minDepth is not updated: the last circle that covers the pixel wins
// task: implicit2DRenderer
// caught by: renderer-random
// says: depth did not matter
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
