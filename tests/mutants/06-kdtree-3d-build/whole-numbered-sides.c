// mutant: the lengths of the sides are cut to whole numbers before they are compared
// task: choose_split
// caught by: tree-splits
// says: node [0-9]+: cell .* expected [12]
    for (u32 axis = 1; axis < 3; axis++) {
        const int length = (int)(box.max[axis] - box.min[axis]);
        if (length > (int)(box.max[split.axis] - box.min[split.axis])) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
