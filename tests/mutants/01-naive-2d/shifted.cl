// mutant: rows are counted from 1
// task: implicit2DRenderer
// caught by: renderer-random
// says: shifted by one pixel
// looks: shifted-one
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y + 1, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
