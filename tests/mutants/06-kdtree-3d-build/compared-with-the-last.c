// mutant: each side is compared with the one before it only
// task: choose_split
// caught by: split-axis
// says: one other only
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[axis - 1] - box.min[axis - 1]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
