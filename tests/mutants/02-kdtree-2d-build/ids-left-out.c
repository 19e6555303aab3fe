// mutant: the count is written, and no ids
// task: pack_leaf
// caught by: pack-rest
// says: come behind the count, and are not there
    (void)ids;
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map] = n_ids;
    tree->n_map += n_ids + 1;
