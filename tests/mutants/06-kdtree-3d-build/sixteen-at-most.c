// mutant: no more than sixteen spheres go to a child
// task: distribute_spheres
// caught by: tree-lists
// says: is a leaf, expected it to be split
// looks: missing-in-cell
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids && n_child_ids < 16; i++) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
