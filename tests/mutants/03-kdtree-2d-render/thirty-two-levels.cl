// mutant: the search takes 32 steps at most
// task: descent
// caught by: descent-leaf
// says: fixed number of steps
    for (int level = 0; level < 32; level++) {
        if (nodes_flag[id] == LEAF) {
            break;
        }
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
