// mutant: the axis is right, the middle always that of x
// task: choose_split
// caught by: split-middle
// says: middle of x
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[0] + (box.max[0] - box.min[0]) / 2;
