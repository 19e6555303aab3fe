// mutant: a slip of the pen: minX for minY
// task: getContainingChild
// caught by: child-inside
// says: border of the other axis
    const NodeRel node = nodes_Relations[id];
    const BBox2D left = nodes_BBox[node.lChild];
    const int is_left = x >= left.minX && x < left.maxX && y >= left.minX && y < left.maxY;
    return is_left ? node.lChild : node.rChild;
