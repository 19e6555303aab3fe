// mutant: the number returned is never that of the list, and larger than the node's
// task: distribute
// caught by: distribute-list
// says: returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids + 100000000;
