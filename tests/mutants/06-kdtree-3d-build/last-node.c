// mutant: the last node is filled in, not nodes[id]
// task: pack_leaf_range
// caught by: pack-node
// says: another node
    tree->nodes[tree->n_nodes - 1].split_axis = KD_LEAF;
    tree->nodes[tree->n_nodes - 1].first = tree->n_sphere_ids;
    tree->nodes[tree->n_nodes - 1].n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
    (void)id;
