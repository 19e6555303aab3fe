// mutant: ids are counted, not written
// task: distribute
// caught by: distribute-list
// says: not written into
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        n_child_ids += circle_overlaps_box(h_circles[ids[i]], child) != 0;
    }
    (void)child_ids;
    return n_child_ids;
