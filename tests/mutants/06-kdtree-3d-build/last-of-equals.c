// mutant: of equal sides the last is split
// task: choose_split
// caught by: split-axis
// says: equal sides
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] >= box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
