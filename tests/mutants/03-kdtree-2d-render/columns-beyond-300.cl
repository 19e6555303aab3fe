// mutant: columns beyond 300 go to the right child: only the widest picture has any
// task: getContainingChild
// caught by: child-inside
// says: pixel
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const int in_left = x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY && x <= 300;
    return in_left ? lChild : nodes_Relations[id].rChild;
