// mutant: the longest side so far is kept in an int
// task: choose_split
// caught by: split-axis
// says: cut to whole numbers
    int longest = (int)(box.max[0] - box.min[0]);
    for (u32 axis = 1; axis < 3; axis++) {
        const float length = box.max[axis] - box.min[axis];
        if (length > (float)longest) {
            longest = (int)length;
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
