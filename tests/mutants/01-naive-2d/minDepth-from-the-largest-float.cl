// mutant: minDepth starts with FLT_MAX, which a depth may be
// task: implicit2DRenderer
// caught by: renderer-edges
// says: starts too small
    float minDepth = FLT_MAX;
    for (int i = 0; i < n_circles; i++) {
        const Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
