// mutant: minDepth is lowered by circles that do not cover the pixel, too
// task: implicit2DRenderer
// caught by: renderer-edges
// says: do not cover
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            color = (float4)(c.r, c.g, c.b, c.a);
        }
        minDepth = fmin(minDepth, c.depth);
    }
