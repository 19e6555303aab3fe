// mutant: the cell is halved anew
// task: getContainingChild
// caught by: child-inside
// says: into the middle of the cell
    const NodeRel node = nodes_Relations[id];
    const BBox2D box = nodes_BBox[id];
    const float w = box.maxX - box.minX, h = box.maxY - box.minY;
    if (w >= h) {
        return x < box.minX + w / 2 ? node.lChild : node.rChild;
    }
    return y < box.minY + h / 2 ? node.lChild : node.rChild;
