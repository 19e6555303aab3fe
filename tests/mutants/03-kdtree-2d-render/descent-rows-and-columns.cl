// mutant: the leaf of pixel (y, x) is searched
// task: descent
// caught by: descent-leaf
// says: leaf map.*found
// looks: transposed
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(y, x, id, nodes_Relations, nodes_BBox, &work);
    }
