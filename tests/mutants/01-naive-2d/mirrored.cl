// mutant: column 0 is taken for the right one
// task: implicit2DRenderer
// caught by: renderer-random
// says: mirrored
// looks: mirrored-x
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(width - 1 - x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
