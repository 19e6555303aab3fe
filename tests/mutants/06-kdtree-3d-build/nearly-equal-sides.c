// mutant: sides that differ by less than a thousandth count as equal
// task: choose_split
// caught by: split-axis
// says: not equal
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis] + 1e-3f) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
