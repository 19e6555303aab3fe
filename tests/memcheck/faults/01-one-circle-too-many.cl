// fault: the loop asks the circle behind the end of the array
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: reads circles[120], but `circles` has 120 entries, 0 to 119
    float minDepth = INFINITY;
    for (int i = 0; i <= n_circles; i++) {
        const Circle circle = circles[i];  // HERE
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
