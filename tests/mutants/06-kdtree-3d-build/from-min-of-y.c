// mutant: half of the side is added to the minimum of y
// task: choose_split
// caught by: split-middle
// says: the same axis each time
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    const float length = box.max[split.axis] - box.min[split.axis];
    split.pos = box.min[1] + length / 2;
