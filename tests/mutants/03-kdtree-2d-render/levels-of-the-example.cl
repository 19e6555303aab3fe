// mutant: the four levels of the lecture's example are written into the code
// task: descent
// caught by: descent-leaf
// says: leaf map.*found
    for (int level = 1; level < 4 && nodes_flag[id] != LEAF; level++) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
