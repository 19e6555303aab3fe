// mutant: the list ends at sphere 0
// task: pack_leaf_range
// caught by: pack-ids
// says: sphere 0
    tree->nodes[id].split_axis = KD_LEAF;
    tree->nodes[id].first = tree->n_sphere_ids;
    for (u32 i = 0; i < n_ids; i++) {
        if (ids[i] == 0) {
            break;
        }
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
    tree->nodes[id].n_spheres = n_ids;
