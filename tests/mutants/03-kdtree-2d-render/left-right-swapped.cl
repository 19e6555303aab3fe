// mutant: left and right are swapped
// task: getContainingChild
// caught by: child-inside
// says: swapped
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
    return in_left ? nodes_Relations[id].rChild : lChild;
