// mutant: an empty leaf begins at 0
// task: pack_leaf_range
// caught by: pack-node
// says: an empty leaf
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = n_ids > 0 ? tree->n_sphere_ids : 0;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
