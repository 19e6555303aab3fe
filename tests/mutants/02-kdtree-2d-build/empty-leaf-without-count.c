// mutant: an empty leaf gets no count
// task: pack_leaf
// caught by: pack-count
// says: count of 0
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    if (n_ids > 0) {
        tree->mapNode2Circles[tree->n_map++] = n_ids;
        for (u32 i = 0; i < n_ids; i++)
            tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
