// right: all ids copied first, then those that do not belong are closed over
// task: distribute_spheres
    u32 n_kept = 0;
    for (u32 i = 0; i < n_ids; i++) {
        child_ids[i] = ids[i];
    }
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[child_ids[i]], child)) {
            child_ids[n_kept++] = child_ids[i];
        }
    }
    return n_kept;
