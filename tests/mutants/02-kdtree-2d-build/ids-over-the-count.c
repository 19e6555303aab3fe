// mutant: the ids begin where the count stands
// task: pack_leaf
// caught by: pack-count
// says: where the count belongs
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map + i] = ids[i];
    }
    tree->n_map += n_ids + 1;
