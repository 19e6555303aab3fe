// fault: a leaf's list is copied to an array that is too short for it
// lab: 02-kdtree-2d-build
// task: pack_leaf
// says: uses index 4 of an array of 4 entries
    u32 list[4];
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        list[i] = ids[i];  // HERE
    }
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = list[i];
    }
