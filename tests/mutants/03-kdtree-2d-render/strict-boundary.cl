// mutant: a test of its own, which leaves the boundary out
// task: leaf_loop
// caught by: leaf-edges
// says: strict
// looks: strict-boundary
    float minDepth = INFINITY;
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i]];
        const float2 way = (float2)((float)x, (float)y) - (float2)(circle.x, circle.y);
        if (dot(way, way) < circle.radius * circle.radius && circle.depth < minDepth) {
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
