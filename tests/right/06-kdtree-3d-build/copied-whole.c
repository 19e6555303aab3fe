// right: the node as a whole but for split_pos
// task: pack_leaf_range
    const u32 first = tree->n_sphere_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[first + i] = ids[i];
    }
    tree->n_sphere_ids = first + n_ids;
    tree->nodes[id] = (KdNode3){tree->nodes[id].split_pos, KD_LEAF, first, n_ids};
