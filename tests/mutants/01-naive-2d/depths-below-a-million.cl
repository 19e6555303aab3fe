// mutant: minDepth starts at a number that seems large enough
// task: implicit2DRenderer
// caught by: renderer-edges
// says: starts too small
    float minDepth = 1e6f;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
