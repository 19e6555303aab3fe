// mutant: the leaf's cell is cleared, as if only inner nodes needed one
// task: pack_leaf
// caught by: pack-rest
// says: nodes_BBox
    tree->nodes_flag[id] = LEAF;
    tree->nodes_BBox[id] = (BBox2D){0};
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
