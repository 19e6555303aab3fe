// mutant: blue and alpha change places
// task: implicit2DRenderer
// caught by: renderer-random
// says: blue and alpha swapped
// looks: channels-swapped
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.a, circle.b);
        }
    }
