// mutant: x is split, whatever the sides
// task: choose_split
// caught by: split-axis
// says: found axis 0
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
