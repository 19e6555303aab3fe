// mutant: the left child is taken on every level
// task: descent
// caught by: descent-leaf
// says: found|leaf
    (void)nodes_BBox;
    while (nodes_flag[id] != LEAF) {
        id = nodes_Relations[id].lChild;
    }
