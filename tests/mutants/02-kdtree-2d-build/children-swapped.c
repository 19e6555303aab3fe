// mutant: the left child gets the half with the higher coordinates
// task: split_box
// caught by: split-middle
// says: swapped
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->minX = right->maxX = box.minX + width / 2;
    } else {
        left->minY = right->maxY = box.minY + height / 2;
    }
