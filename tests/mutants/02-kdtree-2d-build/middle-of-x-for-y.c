// mutant: the middle of x is the border in y, too
// task: split_box
// caught by: split-middle
// says: other side
    const float middle = (box.minX + box.maxX) / 2;
    if (box.maxX - box.minX >= box.maxY - box.minY) {
        left->maxX = right->minX = middle;
    } else {
        left->maxY = right->minY = middle;
    }
