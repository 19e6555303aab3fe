// mutant: the count stands before the ids
// task: distribute
// caught by: distribute-list
// says: the count is returned
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[++n] = ids[i];
        }
    }
    child_ids[0] = n;
    return n;
