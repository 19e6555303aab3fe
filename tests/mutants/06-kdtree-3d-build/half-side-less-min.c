// mutant: the minimum is taken off
// task: choose_split
// caught by: split-middle
// says: not taken off
    for (u32 i = 1; i < 3; i++) {
        if (box.max[i] - box.min[i] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = i;
        }
    }
    split.pos = (box.max[split.axis] - box.min[split.axis]) / 2 - box.min[split.axis];
