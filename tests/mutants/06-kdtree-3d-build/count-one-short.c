// mutant: the number returned is one short
// task: distribute_spheres
// caught by: distribute-list
// says: returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids > 0 ? n_child_ids - 1 : 0;
