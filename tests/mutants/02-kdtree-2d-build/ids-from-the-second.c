// mutant: the loop over the ids begins at 1
// task: pack_leaf
// caught by: pack-rest
// says: one position too early
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map] = n_ids;
    for (u32 i = 1; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map + i] = ids[i];
    }
    tree->n_map += n_ids + 1;
