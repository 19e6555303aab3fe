// mutant: y is passed over
// task: choose_split
// caught by: split-axis
// says: y was never split
    for (u32 axis = 0; axis < 3; axis += 2) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = (box.min[split.axis] + box.max[split.axis]) / 2;
