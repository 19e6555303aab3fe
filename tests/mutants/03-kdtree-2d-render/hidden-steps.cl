// mutant: counts the steps aside
// task: descent
// caught by: descent-work
// says: &work
    Work descent_work = {0, 0, 0, 0};
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &descent_work);
    }
