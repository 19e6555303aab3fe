// mutant: x is split always
// task: split_box
// caught by: split-longer
// says: shorter side
    const float width = box.maxX - box.minX;
    left->maxX = right->minX = box.minX + width / 2;
