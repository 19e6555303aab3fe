// mutant: a cell that is one point is split at 0
// task: choose_split
// caught by: split-middle
// says: of no length
    f32 longest = 0;
    for (u32 axis = 0; axis < 3; axis++) {
        const f32 side = box.max[axis] - box.min[axis];
        if (side > longest) {
            longest = side;
            split.axis = axis;
            split.pos = box.min[axis] + side / 2;
        }
    }
