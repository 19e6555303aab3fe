// fault: asks one child after the other, also beyond the last node, until one holds the pixel
// lab: 03-kdtree-2d-render
// task: getContainingChild
// says: reads nodes_BBox[
    for (uint child = nodes_Relations[id].lChild;; child++) {
        const BBox2D box = nodes_BBox[child];  // HERE
        if (x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY) {
            return child;
        }
    }
