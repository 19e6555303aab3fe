// mutant: y is taken to grow upwards: the left child gets the higher rows first
// task: split_box
// caught by: split-middle
// says: swapped
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->minY = right->maxY = box.minY + height / 2;
    }
