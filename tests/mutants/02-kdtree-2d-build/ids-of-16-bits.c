// mutant: the ids are cut to 16 bits
// task: pack_leaf
// caught by: pack-rest
// says: 16 bits
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = (unsigned short)ids[i];
    }
