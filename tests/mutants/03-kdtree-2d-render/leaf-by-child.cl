// mutant: a node without a left child is taken for a leaf, whatever its flag says
// task: descent
// caught by: descent-leaf
// says: nodes_flag
    (void)nodes_flag;
    while (nodes_Relations[id].lChild != 0) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
