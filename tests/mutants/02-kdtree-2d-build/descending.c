// mutant: ids[] is walked through from its end, so the lists come out descending
// task: distribute
// caught by: tree-lists
// says: ascend
    u32 n_child_ids = 0;
    for (u32 i = n_ids; i-- > 0;) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
