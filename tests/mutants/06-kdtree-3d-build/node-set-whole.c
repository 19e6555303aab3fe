// mutant: the whole node is set
// task: pack_leaf_range
// caught by: pack-ids
// says: split_pos is set, too
    KdNode3 leaf = {0, KD_LEAF, tree->n_sphere_ids, n_ids};
    tree->nodes[id] = leaf;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids + i] = ids[i];
    }
    tree->n_sphere_ids += n_ids;
