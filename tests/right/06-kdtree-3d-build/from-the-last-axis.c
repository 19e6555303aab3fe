// right: from z to x, >= lets the earlier axis win; the borders' mean
// task: choose_split
    f32 longest = -INFINITY;
    for (int axis = 2; axis >= 0; axis--) {
        const f32 side = box.max[axis] - box.min[axis];
        if (side >= longest) {
            longest = side;
            split.axis = (u32)axis;
        }
    }
    split.pos = (f32)(((double)box.min[split.axis] + box.max[split.axis]) / 2);
