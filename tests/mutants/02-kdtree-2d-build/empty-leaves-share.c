// mutant: an empty leaf shares the list of the empty leaf before it
// task: pack_leaf
// caught by: tree-packing
// says: circleMapOffset is
    tree->nodes_flag[id] = LEAF;
    for (u32 leaf = 0; n_ids == 0 && leaf < id; leaf++) {
        const u32 offset = tree->nodes_Relations[leaf].circleMapOffset;
        if (tree->nodes_flag[leaf] == LEAF && tree->mapNode2Circles[offset] == 0) {
            tree->nodes_Relations[id].circleMapOffset = offset;
            return;
        }
    }
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
