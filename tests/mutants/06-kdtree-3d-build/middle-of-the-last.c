// mutant: the middle of z, whatever the axis
// task: choose_split
// caught by: split-middle
// says: middle of z
    float best = 0;
    for (u32 a = 0; a < 3; a++) {
        float len = box.max[a] - box.min[a];
        if (len > best) {
            best = len;
            split.axis = a;
        }
        split.pos = box.min[a] + len / 2;
    }
