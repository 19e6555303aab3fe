// mutant: the middle in y is kept in an int
// task: split_box
// caught by: split-middle
// says: the middle was made a whole number
    if (box.maxX - box.minX >= box.maxY - box.minY) {
        left->maxX = right->minX = (box.minX + box.maxX) / 2;
    } else {
        const int middle = (int)((box.minY + box.maxY) / 2);
        left->maxY = right->minY = (float)middle;
    }
