// right: inside the node only the left child's upper sides can part the two
// task: getContainingChild
    const uint left = nodes_Relations[id].lChild;
    const uint right = nodes_Relations[id].rChild;
    return x < nodes_BBox[left].maxX && y < nodes_BBox[left].maxY ? left : right;
