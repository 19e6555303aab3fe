// mutant: y is split where both sides are equal
// task: split_box
// caught by: split-longer
// says: equal
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width > height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
