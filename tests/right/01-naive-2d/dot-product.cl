// right: vectors: the difference's dot product with itself
// task: overlaps_N_Nearer
    const float2 way = (float2)(circle.x, circle.y) - (float2)(x, y);
    const int is_inside = dot(way, way) <= pown(circle.radius, 2);
    const int is_nearer = minDepth > circle.depth;
    return is_inside & is_nearer;
