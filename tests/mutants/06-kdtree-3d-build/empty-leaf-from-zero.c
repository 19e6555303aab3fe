// mutant: an empty leaf gets no range
// task: pack_leaf_range
// caught by: tree-packing
// says: first is 0
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->n_spheres = n_ids;
    if (n_ids == 0) {
        node->first = 0;
        return;
    }
    node->first = tree->n_sphere_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
