// mutant: the right child is asked, and its lower borders are left out
// task: getContainingChild
// caught by: child-inside
// says: exactly on a border
    const uint right = nodes_Relations[id].rChild;
    const BBox2D b = nodes_BBox[right];
    if (x > b.minX && x < b.maxX && y > b.minY && y < b.maxY) {
        return right;
    }
    return nodes_Relations[id].lChild;
