// mutant: y and z are compared with x only: the longest so far is not remembered
// task: choose_split
// caught by: split-axis
// says: one other only
    const f32 longest = box.max[0] - box.min[0];
    for (u32 axis = 1; axis < 3; axis++) {
        const f32 side = box.max[axis] - box.min[axis];
        if (side > longest) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
