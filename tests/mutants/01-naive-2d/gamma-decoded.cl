// mutant: the colours are taken for encoded ones, and decoded as sRGB
// task: implicit2DRenderer
// caught by: renderer-random
// says: gamma
// looks: gamma
    float minDepth = INFINITY;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
    const float3 encoded = color.xyz;
    const float3 bent = pow((encoded + 0.055f) / 1.055f, 2.4f);
    color.xyz = select(bent, encoded / 12.92f, encoded <= 0.04045f);
