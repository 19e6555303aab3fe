// mutant: cells are compared as unsigned numbers
// task: getContainingChild
// caught by: child-inside
// says: negative
    const BBox2D b = nodes_BBox[nodes_Relations[id].lChild];
    const uint px = (uint)x, py = (uint)y;
    const uint left = (uint)(int)floor(b.minX), top = (uint)(int)floor(b.minY);
    if (px >= left && px < b.maxX && py >= top && py < b.maxY)
        return nodes_Relations[id].lChild;
    return nodes_Relations[id].rChild;
