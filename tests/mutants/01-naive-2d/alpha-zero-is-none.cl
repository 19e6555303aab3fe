// mutant: alpha 0 is taken for "no circle yet"
// task: implicit2DRenderer
// caught by: renderer-edges
// says: colour of zeros
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, color.w == 0.0f ? INFINITY : minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
