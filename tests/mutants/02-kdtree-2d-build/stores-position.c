// mutant: the circle's position in ids[] is stored instead of its id
// task: distribute
// caught by: distribute-list
// says: child_ids\[|returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = i;
        }
    }
    return n_child_ids;
