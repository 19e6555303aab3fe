// mutant: a test of its own, at the middle of the pixel
// task: leaf_loop
// caught by: leaf-random
// says: half a pixel
// looks: shifted-half
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        const float2 way = (float2)(x + 0.5f, y + 0.5f) - (float2)(circle.x, circle.y);
        if (dot(way, way) <= circle.radius * circle.radius && circle.depth < minDepth) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
