// mutant: getContainingChild is called once for the left child and again for the right one
// task: descent
// caught by: descent-work
// says: more than once
    while (nodes_flag[id] != LEAF) {
        const NodeRel node = nodes_Relations[id];
        if (getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work) == node.lChild) {
            id = node.lChild;
        } else if (getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work) == node.rChild) {
            id = node.rChild;
        }
    }
