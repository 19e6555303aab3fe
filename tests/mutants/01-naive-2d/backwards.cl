// mutant: circles are asked from the last to the first, so the later of two equals is kept
// task: implicit2DRenderer
// caught by: renderer-order
// says: equal depth
// looks: later-of-equals
    float minDepth = INFINITY;
    for (int i = n_circles - 1; i >= 0; i--) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
