// mutant: the leaf of pixel (x, height - 1 - y) is searched
// task: descent
// caught by: descent-leaf
// says: flipped
// never says: position in the list
// looks: flipped-y
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, height - 1 - y, id, nodes_Relations, nodes_BBox, &work);
    }
