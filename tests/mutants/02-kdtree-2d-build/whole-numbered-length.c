// mutant: width and height are kept in an int
// task: split_box
// caught by: split-middle
// says: length of a side was made a whole number
    const int width = box.maxX - box.minX;
    const int height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
