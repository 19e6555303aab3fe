// right: memcpy, and the node as a whole but for split_pos
// task: pack_leaf_range
    const u32 first = tree->n_sphere_ids;
    if (n_ids > 0) {
        memcpy(tree->sphere_ids + first, ids, n_ids * sizeof *ids);
    }
    tree->n_sphere_ids = first + n_ids;
    tree->nodes[id] = (KdNode3){tree->nodes[id].split_pos, KD_LEAF, first, n_ids};
