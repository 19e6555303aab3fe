// mutant: the ids are written from the last to the first
// task: pack_leaf_range
// caught by: tree-packing
// says: ascend
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = n_ids; i > 0; i--) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i - 1];
    }
