// mutant: y is compared with all four borders
// task: getContainingChild
// caught by: child-inside
// says: border of the other axis
    const NodeRel node = nodes_Relations[id];
    const BBox2D left = nodes_BBox[node.lChild];
    const int is_left = y >= left.minX && y < left.maxX && y >= left.minY && y < left.maxY;
    (void)x;
    return is_left ? node.lChild : node.rChild;
