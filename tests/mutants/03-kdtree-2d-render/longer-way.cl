// mutant: another leaf is searched, on a longer way: no node is asked twice
// task: descent
// caught by: descent-work
// says: on the way to the leaf$
// looks: transposed
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(y, x, id, nodes_Relations, nodes_BBox, &work);
    }
