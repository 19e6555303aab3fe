// mutant: only x is compared, so cells split across y are not searched
// task: getContainingChild
// caught by: child-inside
// says: one axis
    (void)y;
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX;
    return in_left ? lChild : nodes_Relations[id].rChild;
