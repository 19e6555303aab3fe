// mutant: the middle of the pixel is looked for, not its coordinate
// task: getContainingChild
// caught by: child-inside
// says: shifted by half
// looks: shifted-half
    const uint lChild = nodes_Relations[id].lChild;
    const BBox2D box = nodes_BBox[lChild];
    const float px = x + 0.5f;
    const float py = y + 0.5f;
    const int in_left = px >= box.minX && px < box.maxX && py >= box.minY && py < box.maxY;
    return in_left ? lChild : nodes_Relations[id].rChild;
