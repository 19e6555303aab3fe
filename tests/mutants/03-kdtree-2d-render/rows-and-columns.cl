// mutant: x is compared with the rows and y with the columns
// task: getContainingChild
// caught by: child-inside
// says: other axis
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = y >= box.minX && y < box.maxX && x >= box.minY && x < box.maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
