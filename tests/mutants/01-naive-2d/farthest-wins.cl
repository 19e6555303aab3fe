// mutant: the greatest depth is kept instead of the smallest
// task: implicit2DRenderer
// caught by: renderer-random
// says: farthest
    float maxDepth = -INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, INFINITY, &work) && circle.depth > maxDepth) {
            maxDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
