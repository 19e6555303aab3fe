// mutant: a pixel outside the root leaves at once, and nobody writes it
// task: descent
// caught by: descent-picture
// says: nobody wrote
// looks: unwritten
    const BBox2D root = nodes_BBox[0];
    if (x < root.minX || x >= root.maxX || y < root.minY || y >= root.maxY) {
        return;
    }
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
