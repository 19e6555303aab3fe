// mutant: FLT_EPSILON decides whether sides are equal
// task: choose_split
// caught by: split-axis
// says: not equal
    for (u32 axis = 1; axis < 3; axis++) {
        const f32 side = box.max[axis] - box.min[axis];
        if (side - (box.max[split.axis] - box.min[split.axis]) > 1.1920929e-07f) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
