// mutant: all empty leaves get the list of the first one, which is remembered
// task: pack_leaf
// caught by: pack-offset
// says: circleMapOffset is
    static u32 empty_list = 0xffffffff;
    tree->nodes_flag[id] = LEAF;
    if (n_ids == 0 && empty_list != 0xffffffff) {
        tree->nodes_Relations[id].circleMapOffset = empty_list;
        return;
    }
    empty_list = n_ids == 0 ? tree->n_map : empty_list;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
