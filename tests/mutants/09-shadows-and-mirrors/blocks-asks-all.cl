// mutant: goes on behind the first one in the way
// task: leaf_blocks
// caught by: blocks-early
// says: one in the way is enough
    int is_blocked = 0;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        is_blocked |= intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max;
    }
    return is_blocked;
