// mutant: the row is asked for as x and the column as y
// task: implicit2DRenderer
// caught by: renderer-random
// says: transposed
// looks: transposed
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(y, x, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
