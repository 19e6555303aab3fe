// mutant: a child gets all spheres of its parent
// task: distribute_spheres
// caught by: distribute-list
// says: child_ids\[|returned
    (void)h_spheres, (void)child;
    for (u32 i = 0; i < n_ids; i++) {
        child_ids[i] = ids[i];
    }
    return n_ids;
