// mutant: the last sphere decides
// task: leaf_blocks
// caught by: blocks-before
// says: last sphere decides
    int is_blocked = 0;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        is_blocked = intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max;
    }
    return is_blocked;
