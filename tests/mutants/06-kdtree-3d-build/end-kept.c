// mutant: the end is kept in a static variable
// task: pack_leaf_range
// caught by: pack-node
// says: kept from the tree
    static u32 end;
    KdNode3 *node = &tree->nodes[id];
    if (id == 0) {
        end = 0;
    }
    *node = (KdNode3){node->split_pos, KD_LEAF, end, n_ids};
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[end++] = ids[i];
    }
    tree->n_sphere_ids = end;
