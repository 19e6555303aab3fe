// mutant: true is -1, as in vectors
// task: overlaps_N_Nearer
// caught by: overlaps-inside
// says: no other number
    float2 d = (float2)(x, y) - (float2)(circle.x, circle.y);
    int2 both = (float2)(dot(d, d), circle.depth) <= (float2)(circle.radius * circle.radius, nextafter(minDepth, -INFINITY));
    return both.x & both.y;
