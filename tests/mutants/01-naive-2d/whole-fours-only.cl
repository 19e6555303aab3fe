// mutant: the rest behind whole groups of four is not asked
// task: implicit2DRenderer
// caught by: renderer-edges
// says: last circles were missing
    float minDepth = INFINITY;
    for (int i = 0; i + 4 <= n_circles; i += 4) {
        for (int k = 0; k < 4; k++) {
            Circle c = circles[i + k];
            if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
                minDepth = c.depth;
                color = (float4)(c.r, c.g, c.b, c.a);
            }
        }
    }
