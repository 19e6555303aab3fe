// mutant: n_map stays where it was, so the next leaf overwrites the list
// task: pack_leaf
// caught by: pack-rest
// says: n_map is
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map + 1 + i] = ids[i];
    }
