// mutant: half of the side is a whole number
// task: choose_split
// caught by: split-middle
// says: made a whole number
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    const int half = (int)((box.max[split.axis] - box.min[split.axis]) / 2);
    split.pos = box.min[split.axis] + half;
