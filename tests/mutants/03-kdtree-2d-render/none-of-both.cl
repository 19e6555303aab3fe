// mutant: a pixel that neither child holds is sent to node 0
// task: getContainingChild
// caught by: child-inside
// says: no child of the node
    const uint children[2] = {nodes_Relations[id].lChild, nodes_Relations[id].rChild};
    for (int i = 0; i < 2; i++) {
        const BBox2D box = nodes_BBox[children[i]];
        if (x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY) {
            return children[i];
        }
    }
    return 0;
