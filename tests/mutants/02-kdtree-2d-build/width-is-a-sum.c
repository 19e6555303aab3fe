// mutant: plus for minus in the width
// task: split_box
// caught by: split-longer
// says: a side was computed wrongly
    const float width = box.maxX + box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = (box.minX + box.maxX) / 2;
    } else {
        left->maxY = right->minY = (box.minY + box.maxY) / 2;
    }
