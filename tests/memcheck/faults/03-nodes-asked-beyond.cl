// fault: the child behind the last one is asked
// lab: 03-kdtree-2d-render
// task: leaf_loop
// says: reads circles[
    const uint offset = nodes_Relations[id].circleMapOffset;
    const uint n_circles = mapNode2Circles[offset];
    for (uint i = 1; i <= n_circles; i++) {
        const Circle circle = circles[mapNode2Circles[offset + i] + 1000];  // HERE
        color = (float4)(circle.r, circle.g, circle.b, circle.a);
    }
