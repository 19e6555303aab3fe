// mutant: a tiny epsilon at the upper borders, in case of rounding
// task: getContainingChild
// caught by: child-inside
// says: epsilon
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX - 1e-7f && y >= box.minY && y < box.maxY - 1e-7f;
    return in_left ? lChild : nodes_Relations[id].rChild;
