// mutant: the leaf is looked for in the arrays; the way down is walked for the count alone
// task: descent
// caught by: descent-leaf
// says: looked for in the arrays
    uint node = 0;
    while (nodes_flag[node] != LEAF) {
        node = getContainingChild(x, y, node, nodes_Relations, nodes_BBox, &work);
    }
    for (uint leaf = 0; leaf <= node; leaf++) {
        const BBox2D box = nodes_BBox[leaf];
        if (nodes_flag[leaf] == LEAF && x >= box.minX && x < box.maxX && y >= box.minY &&
            y < box.maxY) {
            id = leaf;
            break;
        }
        id = node;
    }
