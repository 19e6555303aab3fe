// mutant: right lists in all trees but the deepest, whose tiny cells list sphere 0 for every other
// task: distribute_spheres
// caught by: tree-lists
// says: must ascend
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (sphere_overlaps_box(h_spheres[ids[i]], child)) {
            child_ids[n_child_ids++] = child.max[0] - child.min[0] < 1e-3f ? 0 : ids[i];
        }
    }
    return n_child_ids;
