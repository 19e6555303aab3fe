// mutant: no more circles are asked than there are numbers of 16 bits
// task: implicit2DRenderer
// caught by: renderer-edges
// says: end of a long list
    float minDepth = INFINITY;
    for (int i = 0; i < min(n_circles, 65536); i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
