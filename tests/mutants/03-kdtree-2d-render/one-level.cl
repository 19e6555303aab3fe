// mutant: the descent stops after one level: if instead of while
// task: descent
// caught by: descent-leaf
// says: fixed number of steps
    if (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
