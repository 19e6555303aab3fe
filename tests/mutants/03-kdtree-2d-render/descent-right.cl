// mutant: the right child is taken on every level
// task: descent
// caught by: descent-leaf
// says: leaf map.*found
// never says: position in the list
    (void)nodes_BBox;
    while (nodes_flag[id] != LEAF) {
        id = nodes_Relations[id].rChild;
    }
