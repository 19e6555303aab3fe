// mutant: the ids come out descending
// task: distribute_spheres
// caught by: distribute-list
// says: child_ids\[
    u32 n_child_ids = 0;
    for (u32 i = n_ids; i-- > 0;) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
