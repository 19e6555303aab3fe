// mutant: the count is cut to 8 bits
// task: pack_leaf_range
// caught by: pack-node
// says: 8 bits
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = (u8)n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
