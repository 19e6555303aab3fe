// fault: a pointer runs over the end of a private array
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: writes beyond the end of `nearest`
    float minDepth = INFINITY;
    float nearest[4];
    float *next = nearest;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            *next++ = minDepth;  // HERE
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
