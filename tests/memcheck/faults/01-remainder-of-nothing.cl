// fault: a remainder by the number of circles, also where there are none
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: divides by zero
    float minDepth = INFINITY;
    const int first = x % n_circles;  // HERE
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[(first + i) % n_circles];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
