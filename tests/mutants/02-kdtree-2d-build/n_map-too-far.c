// mutant: n_map moves one entry further than the list is long
// task: pack_leaf
// caught by: tree-packing
// says: pack_leaf.. moved n_map by more
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
    tree->n_map++;
