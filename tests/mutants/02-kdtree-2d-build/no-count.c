// mutant: the count is missing: the list begins with the first id
// task: pack_leaf
// caught by: pack-count
// says: count at
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
