// mutant: y comes before x where both are equal
// task: choose_split
// caught by: split-axis
// says: equal sides
    split.axis = 1;
    for (u32 axis = 0; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
