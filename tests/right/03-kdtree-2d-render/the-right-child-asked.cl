// right: the right child's cell is looked at; what is not there is in the left
// task: getContainingChild
    const NodeRel node = nodes_Relations[id];
    const BBox2D cell = nodes_BBox[node.rChild];
    if (x < cell.minX || y < cell.minY || x >= cell.maxX || y >= cell.maxY) {
        return node.lChild;
    }
    return node.rChild;
