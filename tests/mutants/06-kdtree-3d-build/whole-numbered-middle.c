// mutant: the middle is rounded to a whole number
// task: choose_split
// caught by: split-middle
// says: rounded to a whole number
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = floorf(box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2);
