// mutant: minDepth starts with the first circle's depth
// task: implicit2DRenderer
// caught by: renderer-edges
// says: depth of the first circle
// never says: first circle were missing
    float minDepth = n_circles > 0 ? circles[0].depth : 0.0f;
    for (int i = 0; i < n_circles; i++) {
        if (overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
            minDepth = circles[i].depth;
            color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
        }
    }
