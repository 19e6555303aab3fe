// mutant: the right child is taken to be the one behind the left
// task: getContainingChild
// caught by: child-inside
// says: no child of the node
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
    return in_left ? lChild : lChild + 1;
