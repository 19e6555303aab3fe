// mutant: half the width is taken for the middle, as if every cell began at 0
// task: split_box
// caught by: split-middle
// says: found left
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = width / 2;
    } else {
        left->maxY = right->minY = height / 2;
    }
