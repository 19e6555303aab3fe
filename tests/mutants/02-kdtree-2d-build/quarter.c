// mutant: a quarter of the side
// task: split_box
// caught by: split-middle
// says: not in the middle
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 4;
    } else {
        left->maxY = right->minY = box.minY + height / 4;
    }
