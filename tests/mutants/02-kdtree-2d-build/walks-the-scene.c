// mutant: the scene's first circles are walked through instead of the node's
// task: distribute
// caught by: distribute-list
// says: child_ids\[|returned
// looks: missing-in-cell
    (void)ids;
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[i], child)) {
            child_ids[n_child_ids++] = i;
        }
    }
    return n_child_ids;
