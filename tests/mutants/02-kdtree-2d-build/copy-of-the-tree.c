// mutant: n_map moves in a copy of the tree
// task: pack_leaf
// caught by: pack-rest
// says: copy
    KdTree2D t = *tree;
    t.nodes_flag[id] = LEAF;
    t.nodes_Relations[id].circleMapOffset = t.n_map;
    t.mapNode2Circles[t.n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        t.mapNode2Circles[t.n_map++] = ids[i];
    }
