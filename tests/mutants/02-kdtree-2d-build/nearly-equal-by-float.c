// mutant: FLT_EPSILON decides whether sides are equal
// task: split_box
// caught by: split-longer
// says: not equal
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (height - width <= 1.1920929e-07f) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
