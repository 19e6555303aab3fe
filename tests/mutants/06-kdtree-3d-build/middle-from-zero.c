// mutant: half the length, as if every cell began at 0
// task: choose_split
// caught by: split-middle
// says: began at 0
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = (box.max[split.axis] - box.min[split.axis]) / 2;
