// mutant: the position of the last id is returned
// task: distribute
// caught by: distribute-list
// says: how many ids were written
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n] = ids[i];
            n++;
        }
    }
    return n > 0 ? n - 1 : 0;
