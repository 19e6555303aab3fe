// mutant: n_nodes counts the leaf once more
// task: pack_leaf
// caught by: pack-rest
// says: n_nodes
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
    tree->n_nodes++;
