// mutant: the colours are encoded for a screen, with a power of 1 / 2.2
// task: implicit2DRenderer
// caught by: renderer-random
// says: gamma
// looks: gamma
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
    color.xyz = pow(color.xyz, 1.0f / 2.2f);
