// mutant: 16 bits are to hold the place in the map
// task: pack_leaf
// caught by: tree-packing
// says: circleMapOffset
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = (unsigned short)tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
