// mutant: first is where the last id is
// task: pack_leaf_range
// caught by: pack-node
// says: last id
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids] = ids[i];
        tree->nodes[id].first = tree->n_sphere_ids;
        tree->n_sphere_ids++;
    }
