// mutant: the middle is added to the lower border
// task: split_box
// caught by: split-middle
// says: once more
    if (box.maxX - box.minX >= box.maxY - box.minY) {
        left->maxX = right->minX = box.minX + (box.maxX + box.minX) / 2;
    } else {
        left->maxY = right->minY = box.minY + (box.maxY + box.minY) / 2;
    }
