    return circle.depth < minDepth && fabs(x - circle.x) <= circle.radius &&
           fabs(y - circle.y) <= circle.radius;
