// mutant: circleMapOffset is not set
// task: pack_leaf
// caught by: pack-offset
// says: was not set
    tree->nodes_flag[id] = LEAF;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
