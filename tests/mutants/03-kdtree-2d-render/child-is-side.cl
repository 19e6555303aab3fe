// mutant: 0 for the left child and 1 for the right one in the place of their ids
// task: getContainingChild
// caught by: child-inside
// says: 0 and 1 are no ids of its children
    const BBox2D box = nodes_BBox[nodes_Relations[id].lChild];
    return !(x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY);
