// mutant: the node is not marked as a leaf
// task: pack_leaf_range
// caught by: pack-node
// says: split_axis is
    KdNode3 *node = &tree->nodes[id];
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
