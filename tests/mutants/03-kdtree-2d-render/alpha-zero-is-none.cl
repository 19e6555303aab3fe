// mutant: alpha 0 is taken for "no circle yet"
// task: leaf_loop
// caught by: leaf-edges
// says: colour of zeros
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const uint circle_id = mapNode2Circles[offset + i];
        const Circle circle = circles[circle_id];
        if (overlaps_N_Nearer(x, y, circle, color.w == 0.0f ? INFINITY : minDepth, &work)) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
