// fault: three numbers of a colour are set, and the fourth is drawn as it is
// lab: 01-naive-2d
// task: implicit2DRenderer
// at: write_imagef
// says: draws with a value that was never set, of `nearest`
    float4 nearest;
    nearest.xyz = color.xyz;
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            nearest.xyz = (float3)(circle.r, circle.g, circle.b);
        }
    }
    color = nearest;
