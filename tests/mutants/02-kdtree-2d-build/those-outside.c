// mutant: the circles that do not overlap are listed
// task: distribute
// caught by: distribute-list
// says: that do not overlap the cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (!circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
