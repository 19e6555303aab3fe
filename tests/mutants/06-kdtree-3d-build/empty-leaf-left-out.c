// mutant: an empty leaf is not packed
// task: pack_leaf_range
// caught by: pack-node
// says: only empty leaves
    if (n_ids == 0) {
        return;
    }
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids;
    tree->nodes[id].n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
