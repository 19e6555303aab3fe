// mutant: the number of the node's circles is returned instead of the child's
// task: distribute
// caught by: distribute-list
// says: returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_ids;
