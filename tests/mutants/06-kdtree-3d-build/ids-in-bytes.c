// mutant: n_ids bytes are copied
// task: pack_leaf_range
// caught by: pack-ids
// says: as many bytes
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    unsigned char *to = (unsigned char *)(tree->sphere_ids + tree->n_sphere_ids);
    for (u32 i = 0; i < n_ids; i++) {
        to[i] = ((const unsigned char *)ids)[i];
    }
    tree->n_sphere_ids += n_ids;
