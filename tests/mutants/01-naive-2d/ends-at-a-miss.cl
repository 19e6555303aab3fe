// mutant: the loop ends at the first circle that does not take the pixel
// task: implicit2DRenderer
// caught by: renderer-edges
// says: first circle that does not take the pixel
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        if (!overlaps_N_Nearer(x, y, circles[i], minDepth, &work)) {
            break;
        }
        minDepth = circles[i].depth;
        color = (float4)(circles[i].r, circles[i].g, circles[i].b, circles[i].a);
    }
