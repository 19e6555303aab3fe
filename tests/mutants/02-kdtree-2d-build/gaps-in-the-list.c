// mutant: ids stay at their positions
// task: distribute
// caught by: distribute-list
// says: no gaps
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[i] = ids[i];
            n++;
        }
    }
    return n;
