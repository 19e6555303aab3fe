// right: two circles a step, and the odd one at the end
// task: implicit2DRenderer
    float minDepth = INFINITY;
    int i = 0;
    while (i + 1 < n_circles) {
        const Circle one = circles[i];
        const Circle two = circles[i + 1];
        if (overlaps_N_Nearer(x, y, one, minDepth, &work)) {
            minDepth = one.depth;
            color = (float4)(one.r, one.g, one.b, one.a);
        }
        if (overlaps_N_Nearer(x, y, two, minDepth, &work)) {
            minDepth = two.depth;
            color = (float4)(two.r, two.g, two.b, two.a);
        }
        i += 2;
    }
    if (i < n_circles && overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
        color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
    }
