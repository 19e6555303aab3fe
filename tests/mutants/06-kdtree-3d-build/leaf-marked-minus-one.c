// mutant: the leaf is marked with -1 instead of KD_LEAF
// task: pack_leaf_range
// caught by: pack-node
// says: split_axis is
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = 0xffffffff;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
