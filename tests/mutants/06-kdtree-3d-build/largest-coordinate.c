// mutant: the axis that reaches farthest, not the longest
// task: choose_split
// caught by: split-axis
// says: largest coordinate
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] > box.max[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
