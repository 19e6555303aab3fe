// mutant: beyond node 20 circle 148 stands for circle 149
// task: pack_leaf
// caught by: tree-packing
// says: mapNode2Circles|circle
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i] == 149 && id > 20 ? 148 : ids[i];
    }
