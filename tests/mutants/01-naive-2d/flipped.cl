// mutant: row 0 is taken for the bottom row
// task: implicit2DRenderer
// caught by: renderer-random
// says: flipped
// looks: flipped-y
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, height - 1 - y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
