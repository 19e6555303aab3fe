// right: an endless loop that is left at the leaf
// task: descent
    for (;;) {
        if (nodes_flag[id] == LEAF) {
            break;
        }
        const uint child = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
        id = child;
    }
