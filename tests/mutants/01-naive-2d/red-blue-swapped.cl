// mutant: the channels are written as blue, green, red
// task: implicit2DRenderer
// caught by: renderer-random
// says: red and blue swapped
// looks: channels-swapped
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.b, circle.g, circle.r, circle.a);
        }
    }
