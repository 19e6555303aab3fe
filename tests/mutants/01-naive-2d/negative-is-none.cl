// mutant: a negative minDepth says that there is no circle yet
// task: implicit2DRenderer
// caught by: renderer-edges
// says: negative minDepth
    float minDepth = -1.0f;
    for (int i = 0; i < n_circles; i++) {
        Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth < 0.0f ? INFINITY : minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
