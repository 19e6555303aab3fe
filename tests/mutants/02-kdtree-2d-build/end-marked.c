// mutant: an end is marked behind the last id, where there may be no room
// task: distribute
// caught by: distribute-list
// says: there is room for
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    child_ids[n_child_ids] = 0xffffffff;
    return n_child_ids;
