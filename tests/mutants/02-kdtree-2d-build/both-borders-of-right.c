// mutant: the right half gets both borders, the left one none
// task: split_box
// caught by: split-middle
// says: of each half the split moves one
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        right->minX = right->maxX = box.minX + width / 2;
    } else {
        right->minY = right->maxY = box.minY + height / 2;
    }
