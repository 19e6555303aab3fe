// mutant: the left border does not belong to the cell: x > minX
// task: getContainingChild
// caught by: child-border
// says: half-open
// looks: strict-boundary
    const NodeRel rel = nodes_Relations[id];
    const BBox2D box = nodes_BBox[rel.lChild];
    if (x > box.minX && x < box.maxX && y >= box.minY && y < box.maxY) {
        return rel.lChild;
    }
    return rel.rChild;
