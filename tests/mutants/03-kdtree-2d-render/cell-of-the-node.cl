// mutant: the node's own cell is asked instead of its left child's: it always holds the pixel
// task: getContainingChild
// caught by: child-inside
// says: every time
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[id];
    const int in_left = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
