// mutant: the i-th sphere of the scene is asked instead of the node's
// task: distribute_spheres
// caught by: distribute-list
// says: child_ids\[|returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[i], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
