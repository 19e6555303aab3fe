// mutant: 16 bits are to hold the number of circles
// task: implicit2DRenderer
// caught by: renderer-edges
// says: 16 bits
    float minDepth = INFINITY;
    for (int i = 0; i < (ushort)n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
