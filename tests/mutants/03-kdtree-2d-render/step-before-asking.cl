// mutant: the first step is taken before anybody asks whether the root is a leaf
// task: descent
// caught by: descent-work
// says: called 1 time, expected 0
    do {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    } while (nodes_flag[id] != LEAF);
