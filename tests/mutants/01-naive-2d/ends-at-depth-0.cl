// mutant: the loop ends at depth 0
// task: implicit2DRenderer
// caught by: renderer-edges
// says: negative
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles && minDepth > 0.0f; i++) {
        Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
