// fault: minDepth is never set before it is compared
// lab: 01-naive-2d
// task: implicit2DRenderer
// says: uses a value that was never set, of `minDepth`
    float minDepth;
    for (int i = 0; i < n_circles; i++) {
        const Circle circle = circles[i];
        if (circle.depth < minDepth) {  // HERE
            minDepth = circle.depth;
            color = (float4)(circle.r, circle.g, circle.b, circle.a);
        }
    }
