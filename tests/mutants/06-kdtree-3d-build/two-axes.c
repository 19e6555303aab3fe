// mutant: z is never split, as if space were flat
// task: choose_split
// caught by: split-axis
// says: expected 2
    for (u32 axis = 1; axis < 2; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
