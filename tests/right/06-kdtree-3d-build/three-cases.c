// right: three cases written out
// task: choose_split
    const f32 dx = box.max[0] - box.min[0];
    const f32 dy = box.max[1] - box.min[1];
    const f32 dz = box.max[2] - box.min[2];
    if (dx >= dy && dx >= dz) {
        split = (KdSplit){0, box.min[0] + 0.5f * dx};
    } else if (dy >= dz) {
        split = (KdSplit){1, box.min[1] + 0.5f * dy};
    } else {
        split = (KdSplit){2, box.min[2] + 0.5f * dz};
    }
