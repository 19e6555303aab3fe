// mutant: all of the node's circles are handed on without asking
// task: distribute
// caught by: distribute-list
// says: child_ids\[|returned
    (void)h_circles, (void)child;
    for (u32 i = 0; i < n_ids; i++) {
        child_ids[i] = ids[i];
    }
    return n_ids;
