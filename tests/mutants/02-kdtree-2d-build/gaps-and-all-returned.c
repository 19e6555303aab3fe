// mutant: ids stand at their own positions, and all of them are returned
// task: distribute
// caught by: distribute-list
// says: has no gaps
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[i] = ids[i];
        }
    }
    return n_ids;
