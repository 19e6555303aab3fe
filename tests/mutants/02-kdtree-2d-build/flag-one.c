// mutant: nodes_flag is set to 1, as if it said "is a leaf"
// task: pack_leaf
// caught by: pack-rest
// says: nodes_flag
    tree->nodes_flag[id] = 1;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
