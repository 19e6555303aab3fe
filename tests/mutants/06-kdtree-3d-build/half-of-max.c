// mutant: half of the maximum
// task: choose_split
// caught by: split-middle
// says: half of the maximum
    float lengths[3];
    for (int i = 0; i < 3; i++) {
        lengths[i] = box.max[i] - box.min[i];
    }
    u32 axis = 0;
    if (lengths[1] > lengths[axis]) {
        axis = 1;
    }
    if (lengths[2] > lengths[axis]) {
        axis = 2;
    }
    split.axis = axis;
    split.pos = box.max[axis] / 2;
