// mutant: the middle is rounded down to a whole pixel
// task: split_box
// caught by: tree-cells
// says: node .*child
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + floorf(width / 2);
    } else {
        left->maxY = right->minY = box.minY + floorf(height / 2);
    }
