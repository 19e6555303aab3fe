// mutant: positions in the list for ids
// task: pack_leaf_range
// caught by: pack-ids
// says: positions in the list
    KdNode3 *node = &tree->nodes[id];
    (void)ids;
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = i;
    }
