// mutant: the root's flag is asked for ever instead of the node's: the loop does not end
// task: descent
// caught by: descent-picture
// says: time
    while (nodes_flag[0] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
