// mutant: sides are compared as whole numbers
// task: choose_split
// caught by: split-axis
// says: as whole numbers
    int longest = -1;
    for (u32 axis = 0; axis < 3; axis++) {
        const int side = (int)(box.max[axis] - box.min[axis]);
        if (side > longest) {
            longest = side;
            split.axis = axis;
        }
    }
    split.pos = (box.min[split.axis] + box.max[split.axis]) / 2;
