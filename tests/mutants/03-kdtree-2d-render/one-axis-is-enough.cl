// mutant: one direction that fits is enough
// task: getContainingChild
// caught by: child-inside
// says: every time
    const BBox2D b = nodes_BBox[nodes_Relations[id].lChild];
    const int in_x = x >= b.minX && x < b.maxX, in_y = y >= b.minY && y < b.maxY;
    return in_x || in_y ? nodes_Relations[id].lChild : nodes_Relations[id].rChild;
