// mutant: a sphere keeps its place in the list, with gaps before it
// task: distribute_spheres
// caught by: distribute-list
// says: child_ids\[|returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[i] = ids[i];
            n_child_ids++;
        }
    }
    return n_child_ids;
