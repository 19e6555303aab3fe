// mutant: the geometric mean of the ends, which is no number where one is negative
// task: choose_split
// caught by: split-middle
// says: no number|found split at
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = sqrtf(box.min[split.axis] * box.max[split.axis]);
