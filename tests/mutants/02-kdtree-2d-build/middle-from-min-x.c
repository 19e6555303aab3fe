// mutant: the middle of y is counted from minX
// task: split_box
// caught by: split-middle
// says: of the other side
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minX + height / 2;
    }
