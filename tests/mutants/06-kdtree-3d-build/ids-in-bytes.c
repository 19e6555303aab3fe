// mutant: n_ids bytes are copied
// task: pack_leaf_range
// caught by: pack-ids
// says: as many bytes
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    if (n_ids > 0) {
        memcpy(tree->sphere_ids + tree->n_sphere_ids, ids, n_ids);
    }
    tree->n_sphere_ids += n_ids;
