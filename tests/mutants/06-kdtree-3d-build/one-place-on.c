// mutant: first and ids are one place too far
// task: pack_leaf_range
// caught by: pack-ids
// says: one place too far
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids + 1;
    tree->nodes[id].n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[++tree->n_sphere_ids] = ids[i];
    }
