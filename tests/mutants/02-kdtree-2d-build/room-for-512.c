// mutant: no more than 512 ids are looked at
// task: distribute
// caught by: distribute-list
// says: ends after 512 ids
// looks: missing-in-cell
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids && i < 512; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
