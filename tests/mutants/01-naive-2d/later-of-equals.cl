// mutant: of two equal depths the later circle wins: depth <= minDepth in a test of its own
// task: implicit2DRenderer
// caught by: renderer-order
// says: equal depth
// looks: later-of-equals
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, INFINITY, &work) && circle.depth <= minDepth) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
