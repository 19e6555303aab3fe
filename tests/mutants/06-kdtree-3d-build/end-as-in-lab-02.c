// mutant: the end moves on by a place for a count
// task: pack_leaf_range
// caught by: pack-ids
// says: by one too many
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[node->first + i] = ids[i];
    }
    tree->n_sphere_ids += 1 + n_ids;
