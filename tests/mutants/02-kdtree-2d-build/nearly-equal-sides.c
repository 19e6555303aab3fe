// mutant: sides that differ by less than a thousandth count as equal
// task: split_box
// caught by: split-longer
// says: not equal
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height || fabsf(width - height) < 1e-3f) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
