// mutant: the sphere's position in ids[] is stored instead of its id
// task: distribute_spheres
// caught by: distribute-list
// says: position|was not written|returned
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[n_child_ids++] = i;
        }
    }
    return n_child_ids;
