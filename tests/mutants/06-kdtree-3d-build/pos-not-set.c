// mutant: only the axis is set
// task: choose_split
// caught by: split-middle
// says: split.pos is not set
    const float x = box.max[0] - box.min[0], y = box.max[1] - box.min[1],
                z = box.max[2] - box.min[2];
    split.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
