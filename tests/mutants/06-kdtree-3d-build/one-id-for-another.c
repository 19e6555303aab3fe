// mutant: one sphere stands for another one in leaves behind node 40
// task: pack_leaf_range
// caught by: tree-packing
// says: sphere
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        const int is_free = i + 1 < n_ids && ids[i] + 1 < ids[i + 1] && id > 40 && i == 2;
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i] + (u32)is_free;
    }
