// mutant: n_spheres is counted up from what the node held
// task: pack_leaf_range
// caught by: pack-node
// says: counted up
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
        node->n_spheres++;
    }
