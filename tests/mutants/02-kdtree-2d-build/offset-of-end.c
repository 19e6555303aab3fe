// mutant: circleMapOffset is taken after the list is written, so it points behind it
// task: pack_leaf
// caught by: pack-offset
// says: circleMapOffset is
    tree->nodes_flag[id] = LEAF;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
