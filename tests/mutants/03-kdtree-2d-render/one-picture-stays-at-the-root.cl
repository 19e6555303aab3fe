// mutant: the last pixels of a picture of 96x128 stay at the root
// task: descent
// caught by: descent-picture
// says: pixel
    while (nodes_flag[id] != LEAF && !(width == 96 && height == 128 && y > 120)) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
