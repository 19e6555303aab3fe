// mutant: every circle of the node is listed
// task: distribute
// caught by: distribute-list
// says: whether or not it overlaps
    for (u32 i = 0; i < n_ids; i++) {
        child_ids[i] = ids[i];
    }
    (void)h_circles, (void)child;
    return n_ids;
