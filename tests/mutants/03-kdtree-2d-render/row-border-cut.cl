// mutant: the lower border of the left child is kept in an int
// task: getContainingChild
// caught by: child-inside
// says: made a whole number
    const NodeRel node = nodes_Relations[id];
    const BBox2D left = nodes_BBox[node.lChild];
    const int below = left.maxY;
    return x < left.maxX && y < below ? node.lChild : node.rChild;
