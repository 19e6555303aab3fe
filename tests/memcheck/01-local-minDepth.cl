// fault: minDepth is local, so the work-items of a group share it
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: a race
    local float minDepth;
    minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {  // HERE
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
