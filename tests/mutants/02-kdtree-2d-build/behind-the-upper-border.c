// mutant: half the length is added to the upper border
// task: split_box
// caught by: split-middle
// says: to the upper border
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.maxX + width / 2;
    } else {
        left->maxY = right->minY = box.maxY + height / 2;
    }
