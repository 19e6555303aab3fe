// mutant: y is compared with maxX
// task: getContainingChild
// caught by: child-inside
// says: other axis
    const BBox2D b = nodes_BBox[nodes_Relations[id].lChild];
    if (x >= b.minX && x < b.maxX && y >= b.minY && y < b.maxX)
        return nodes_Relations[id].lChild;
    else
        return nodes_Relations[id].rChild;
