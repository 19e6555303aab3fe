// mutant: one id more is written
// task: pack_leaf_range
// caught by: pack-ids
// says: one id too many
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids;
    tree->nodes[id].n_spheres = n_ids;
    for (u32 i = 0; i <= n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids + i] = ids[i];
    }
    tree->n_sphere_ids += n_ids;
