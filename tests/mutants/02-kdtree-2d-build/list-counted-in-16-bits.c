// mutant: 16 bits are to hold the number of ids
// task: distribute
// caught by: tree-lists
// says: 65
    unsigned short n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
