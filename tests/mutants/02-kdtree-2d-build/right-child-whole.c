// mutant: only the left child is cut; the right one keeps the whole cell
// task: split_box
// caught by: split-middle
// says: found left
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = box.minX + width / 2;
    } else {
        left->maxY = box.minY + height / 2;
    }
