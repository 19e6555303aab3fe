// mutant: the lower side does not belong to the cell: > minX and > minY
// task: getContainingChild
// caught by: child-border
// says: half-open
// looks: strict-boundary
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x > box.minX && x < box.maxX && y > box.minY && y < box.maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
