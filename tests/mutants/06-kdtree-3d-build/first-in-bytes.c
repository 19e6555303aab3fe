// mutant: first is an offset in bytes
// task: pack_leaf_range
// caught by: pack-node
// says: not in bytes
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids * (u32)sizeof *tree->sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
