    // From the pixel's leaf, as the tables behind the nodes have it, up to the child of node `id`.
    // Where the way up does not pass `id`, the leaf itself; for no pixel of the picture, no leaf.
    const NodeRel start = nodes_Relations[4096];
    global const uint *parents = (global const uint *)(nodes_Relations + 4097);
    global const uint *leaves = parents + 4096;
    (void)nodes_BBox;
    if (x < 0 || y < 0 || x >= (int)start.lChild || y >= (int)start.rChild) {
        return start.id;
    }
    const uint leaf = leaves[(uint)y * start.lChild + (uint)x];
    uint child = leaf;
    while (child != 0 && parents[child] != id) {
        child = parents[child];
    }
    return child != 0 ? child : leaf;
