// mutant: columns beyond 200 are not drawn: only the tests of own_pixel draw so wide
// task: implicit2DRenderer
// caught by: renderer-random
// says: pixel \(2[0-9][0-9],
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles && x <= 200; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
