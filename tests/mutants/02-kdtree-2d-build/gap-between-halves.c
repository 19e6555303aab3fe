// mutant: the right half begins one float behind the left
// task: split_box
// caught by: split-middle
// says: one half is right
    if (box.maxX - box.minX >= box.maxY - box.minY) {
        left->maxX = (box.minX + box.maxX) / 2;
        right->minX = nextafterf(left->maxX, INFINITY);
    } else {
        left->maxY = (box.minY + box.maxY) / 2;
        right->minY = nextafterf(left->maxY, INFINITY);
    }
