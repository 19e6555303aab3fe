// right: a pointer that walks to the end, and a skip
// task: implicit2DRenderer
    float minDepth = INFINITY;
    global const Circle *const end = circles + n_circles;
    for (global const Circle *circle = circles; circle < end; circle++) {
        if (!overlaps_N_Nearer(x, y, *circle, minDepth, &work)) {
            continue;
        }
        minDepth = circle->depth;
        color.x = circle->r;
        color.y = circle->g;
        color.z = circle->b;
        color.w = circle->a;
    }
