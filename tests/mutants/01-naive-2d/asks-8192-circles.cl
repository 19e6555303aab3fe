// mutant: no more circles are asked than the lecture has
// task: implicit2DRenderer
// caught by: renderer-edges
// says: end of a long list
    float minDepth = INFINITY;
    for (int i = 0; i < min(n_circles, 8192); i++) {
        Circle c = circles[i];
        if (overlaps_N_Nearer(x, y, c, minDepth, &work)) {
            minDepth = c.depth;
            color = (float4)(c.r, c.g, c.b, c.a);
        }
    }
