    // The way to the pixel's leaf stands in tables behind the nodes, a bit a level: to the left or
    // the right. For what is no pixel of the picture, a leaf that is nobody's.
    const NodeRel start = nodes_Relations[4096];
    global const uint *levels = (global const uint *)(nodes_Relations + 4097);
    (void)nodes_BBox;
    if (x < 0 || y < 0 || x >= (int)start.lChild || y >= (int)start.rChild) {
        return start.id;
    }
    const uint way = levels[4096 + (uint)y * start.lChild + (uint)x];
    return (way >> levels[id] & 1u) != 0u ? nodes_Relations[id].rChild : nodes_Relations[id].lChild;
