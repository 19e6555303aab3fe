// mutant: the search ends in cells under a pixel
// task: descent
// caught by: descent-leaf
// says: small cell
    while (nodes_flag[id] == INNER && nodes_BBox[id].maxX - nodes_BBox[id].minX >= 1.0f) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
