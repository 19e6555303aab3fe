// mutant: the colours are encoded for a screen, by the sRGB curve
// task: leaf_loop
// caught by: leaf-random
// says: gamma
// looks: gamma
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        if (overlaps_N_Nearer(x, y, circle, minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
    const float3 bent = 1.055f * pow(color.xyz, 1.0f / 2.4f) - 0.055f;
    color.xyz = select(bent, 12.92f * color.xyz, color.xyz <= 0.0031308f);
