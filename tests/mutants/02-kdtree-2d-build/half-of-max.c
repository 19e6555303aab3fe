// mutant: half of the upper border
// task: split_box
// caught by: split-middle
// says: half of the upper border
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.maxX / 2;
    } else {
        left->maxY = right->minY = box.maxY / 2;
    }
