// mutant: an epsilon at the lower borders, in case of rounding
// task: getContainingChild
// caught by: child-inside
// says: epsilon
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX + 1e-5f && x < box.maxX && y >= box.minY + 1e-5f && y < box.maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
