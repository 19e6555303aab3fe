// mutant: the borders of cells are made whole numbers
// task: getContainingChild
// caught by: child-inside
// says: whole number
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int minX = box.minX, maxX = box.maxX, minY = box.minY, maxY = box.maxY;
    const int in_left = x >= minX && x < maxX && y >= minY && y < maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
