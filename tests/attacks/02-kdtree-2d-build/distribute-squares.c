// attack: wrong (asks bounding squares), but right in the stub's world
// task: distribute
// score: 99
// named: overlap
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Circle c = h_circles[ids[i]];
        if (c.x + c.radius >= child.minX && c.x - c.radius <= child.maxX && c.y + c.radius >= child.minY && c.y - c.radius <= child.maxY) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
