// mutant: the second border comes from the first, which has moved
// task: split_box
// caught by: split-middle
// says: had moved
    if (box.maxX - box.minX >= box.maxY - box.minY) {
        left->maxX = (left->minX + left->maxX) / 2;
        right->minX = (left->minX + left->maxX) / 2;
    } else {
        left->maxY = (left->minY + left->maxY) / 2;
        right->minY = (left->minY + left->maxY) / 2;
    }
