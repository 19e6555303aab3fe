// mutant: first is not set
// task: pack_leaf_range
// caught by: pack-node
// says: first is not set
    KdNode3 *node = tree->nodes + id;
    node->split_axis = KD_LEAF;
    node->n_spheres = 0;
    while (node->n_spheres < n_ids) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[node->n_spheres++];
    }
