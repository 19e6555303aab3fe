// right: OpenCL's functions for comparisons, and the distance in double precision
// task: overlaps_N_Nearer
    const double2 way = (double2)(circle.x, circle.y) - convert_double2((int2)(x, y));
    const double radius = circle.radius;
    return isless(circle.depth, minDepth) && islessequal(dot(way, way), radius * radius);
