// mutant: the leaf of pixel (width - 1 - x, y) is searched
// task: descent
// caught by: descent-leaf
// says: mirrored
// looks: mirrored-x
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(width - 1 - x, y, id, nodes_Relations, nodes_BBox, &work);
    }
