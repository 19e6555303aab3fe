// mutant: the whole NodeRel is replaced
// task: pack_leaf
// caught by: pack-rest
// says: only circleMapOffset
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id] = (NodeRel){.circleMapOffset = tree->n_map};
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
