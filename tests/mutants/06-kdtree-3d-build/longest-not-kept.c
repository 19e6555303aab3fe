// mutant: the longest side so far is not kept
// task: choose_split
// caught by: split-axis
// says: was not kept
    f32 longest = 0;
    for (u32 i = 0; i < 3; i++) {
        f32 length = box.max[i] - box.min[i];
        if (length > longest) {
            split.axis = i;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
