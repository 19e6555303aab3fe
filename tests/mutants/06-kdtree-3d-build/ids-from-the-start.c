// mutant: the ids go to the array's beginning
// task: pack_leaf_range
// caught by: pack-ids
// says: array's beginning
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[i] = ids[i];
    }
    tree->n_sphere_ids += n_ids;
