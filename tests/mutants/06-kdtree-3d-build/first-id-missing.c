// mutant: the ids are counted from 1
// task: pack_leaf_range
// caught by: pack-ids
// says: first id is missing
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids;
    tree->nodes[id].n_spheres = n_ids;
    u32 i = 1;
    while (i < n_ids) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i++];
    }
