// mutant: n_map is moved by the ids and not by their count: the next list overwrites the last id
// task: pack_leaf
// caught by: tree-packing
// says: circleMapOffset|entries
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map + 1 + i] = ids[i];
    }
    tree->n_map += n_ids;
