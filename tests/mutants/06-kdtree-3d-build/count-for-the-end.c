// mutant: the count is taken for the end of the range
// task: pack_leaf_range
// caught by: pack-ids
// says: end of the range
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids;
    tree->nodes[id].n_spheres = n_ids;
    for (u32 i = tree->n_sphere_ids; i < n_ids; i++) {
        tree->sphere_ids[i] = ids[i];
    }
    tree->n_sphere_ids += n_ids;
