// mutant: the descent stops after one level: if instead of while
// task: descent
// caught by: descent-picture
// says: list at the start of mapNode2Circles|looks empty
    if (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
