// mutant: the whole node is written, split_pos, too
// task: pack_leaf_range
// caught by: pack-ids
// says: split_pos
    tree->nodes[id] = (KdNode3){0, KD_LEAF, tree->n_sphere_ids, n_ids};
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids + i] = ids[i];
    }
    tree->n_sphere_ids += n_ids;
