// mutant: colours are multiplied by alpha
// task: implicit2DRenderer
// caught by: renderer-random
// says: multiplied by alpha
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)((float3)(c.r, c.g, c.b) * c.a, c.a);
        }
    }
