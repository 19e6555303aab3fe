// mutant: the leaf of the pixel below is searched
// task: descent
// caught by: descent-leaf
// says: shifted by one pixel
// looks: shifted-one
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y + 1, id, nodes_Relations, nodes_BBox, &work);
    }
