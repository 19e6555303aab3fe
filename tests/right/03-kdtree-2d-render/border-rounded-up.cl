// right: the first whole coordinate behind the border, compared with the pixel's
// task: getContainingChild
    const uint left = nodes_Relations[id].lChild;
    const BBox2D cell = nodes_BBox[left];
    const int2 begin = (int2)((int)ceil(cell.minX), (int)ceil(cell.minY));
    const int2 end = (int2)((int)ceil(cell.maxX), (int)ceil(cell.maxY));
    const int is_outside = x < begin.x || y < begin.y || x >= end.x || y >= end.y;
    return is_outside ? nodes_Relations[id].rChild : left;
