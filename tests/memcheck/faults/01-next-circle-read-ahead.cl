// fault: the next circle is read ahead of its turn, also behind the last one
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: reads circles[120], but `circles` has 120 entries, 0 to 119
    float minDepth = INFINITY;
    Circle next = circles[0];
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = next;
        next = circles[i + 1];  // HERE
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
