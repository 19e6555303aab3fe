// right: the list from its last id to its count; n_map moves first
// task: pack_leaf
    u32 *list = tree->mapNode2Circles + tree->n_map;
    const u32 offset = tree->n_map;
    tree->n_map += n_ids + 1;
    for (u32 i = n_ids; i > 0; i--) {
        list[i] = ids[i - 1];
    }
    list[0] = n_ids;
    tree->nodes_Relations[id].circleMapOffset = offset;
    tree->nodes_flag[id] = LEAF;
