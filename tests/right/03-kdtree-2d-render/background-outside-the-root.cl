// right: a pixel outside the root is background at once
// task: descent
    const BBox2D root = nodes_BBox[id];
    if (x < root.minX || x >= root.maxX || y < root.minY || y >= root.maxY) {
        write_imagef(image, (int2)(x, y), (float4)(0.0f));
        return;
    }
    while (nodes_flag[id] != LEAF) {
        id = getContainingChild(x, y, id, nodes_Relations, nodes_BBox, &work);
    }
