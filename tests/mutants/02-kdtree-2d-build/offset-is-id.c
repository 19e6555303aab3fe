// mutant: the offset is the node's id
// task: pack_leaf
// caught by: pack-offset
// says: the node's id
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = id;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
