// mutant: the position moves on before it is used
// task: distribute
// caught by: distribute-list
// says: positions count from 0
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[++n] = ids[i];
        }
    }
    return n;
