// mutant: the sides are compared as whole numbers
// task: split_box
// caught by: split-longer
// says: shorter side|not equal, if nearly
    const int width = (int)(box.maxX - box.minX);
    const int height = (int)(box.maxY - box.minY);
    if (width >= height) {
        left->maxX = right->minX = (box.minX + box.maxX) / 2;
    } else {
        left->maxY = right->minY = (box.minY + box.maxY) / 2;
    }
