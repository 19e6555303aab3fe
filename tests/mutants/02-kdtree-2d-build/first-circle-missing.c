// mutant: the loop starts at 1
// task: distribute
// caught by: distribute-list
// says: child_ids\[|returned
// looks: missing-in-cell
    u32 n_child_ids = 0;
    for (u32 i = 1; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
