// mutant: the child's flag is asked, so the descent ends above the leaf
// task: descent
// caught by: descent-picture
// says: found
    while (nodes_flag[getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work)] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
