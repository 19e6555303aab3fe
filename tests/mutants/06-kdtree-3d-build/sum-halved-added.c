// mutant: half of the sum of both ends is added to the minimum
// task: choose_split
// caught by: split-middle
// says: half of the length
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + 0.5f * (box.min[split.axis] + box.max[split.axis]);
