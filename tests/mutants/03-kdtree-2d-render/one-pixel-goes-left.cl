// mutant: one pixel goes to the left child wherever it is
// task: getContainingChild
// caught by: child-inside
// says: pixel \(70, 7\)
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
    return in_left || (x == 70 && y == 7) ? lChild : nodes_Relations[id].rChild;
