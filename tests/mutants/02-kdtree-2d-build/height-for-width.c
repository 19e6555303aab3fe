// mutant: the middle in x is found with the height
// task: split_box
// caught by: split-middle
// says: length of the other side
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + height / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
