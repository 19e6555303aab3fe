// mutant: the next node's offset is set, too
// task: pack_leaf
// caught by: pack-rest
// says: another node
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++)
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    if (id + 1 < tree->n_nodes)
        tree->nodes_Relations[id + 1].circleMapOffset = tree->n_map;
