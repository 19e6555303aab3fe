// mutant: the ids are written from the last to the first
// task: pack_leaf
// caught by: tree-packing
// says: ascend
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = n_ids; i > 0; i--) {
        tree->mapNode2Circles[tree->n_map++] = ids[i - 1];
    }
