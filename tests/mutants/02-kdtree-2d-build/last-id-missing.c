// mutant: the last id is not written
// task: pack_leaf
// caught by: pack-rest
// says: id number
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i + 1 < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
