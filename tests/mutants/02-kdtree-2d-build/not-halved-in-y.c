// mutant: the height is not halved
// task: split_box
// caught by: split-middle
// says: not half of it
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height;
    }
