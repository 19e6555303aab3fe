// mutant: 8 bits are to count the steps
// task: descent
// caught by: descent-leaf
// says: fixed number of steps
    for (uchar step = 0; step < 255 && nodes_flag[id] != LEAF; step++) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
