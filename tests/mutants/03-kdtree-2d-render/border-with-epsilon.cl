// mutant: a cell ends a little before its border
// task: getContainingChild
// caught by: child-inside
// says: epsilon
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const float eps = 1e-4f;
    const int in_left =
        x >= box.minX && x < box.maxX - eps && y >= box.minY && y < box.maxY - eps;
    return in_left ? lChild : nodes_Relations[id].rChild;
