// mutant: the search ends in cells that are under a pixel both ways
// task: descent
// caught by: descent-leaf
// says: small cell
    while (nodes_flag[id] == INNER) {
        const BBox2D cell = nodes_BBox[id];
        if (cell.maxX - cell.minX < 1.0f && cell.maxY - cell.minY < 1.0f) {
            break;
        }
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
