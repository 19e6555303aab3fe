// mutant: > for < at maxX
// task: getContainingChild
// caught by: child-inside
// says: wrong way round
    const NodeRel node = nodes_Relations[id];
    const BBox2D left = nodes_BBox[node.lChild];
    const int is_left = x >= left.minX && x > left.maxX && y >= left.minY && y < left.maxY;
    return is_left ? node.lChild : node.rChild;
