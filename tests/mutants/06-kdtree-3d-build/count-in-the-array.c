// mutant: the count is written before the ids, as in lab 02
// task: pack_leaf_range
// caught by: pack-ids
// says: as in lab 02
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    tree->sphere_ids[tree->n_sphere_ids++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
