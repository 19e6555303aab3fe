// mutant: calls getContainingChild twice a step
// task: descent
// caught by: descent-work
// says: more than once
    while (nodes_flag[id] == INNER) {
        if (getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work) == nodes_Relations[id].lChild) {
            id = nodes_Relations[id].lChild;
        } else {
            id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
        }
    }
