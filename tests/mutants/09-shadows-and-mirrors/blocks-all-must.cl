// mutant: every sphere must be in the way
// task: leaf_blocks
// caught by: blocks-before
// says: not all must be
    uint n_blockers = 0;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        n_blockers += intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max;
    }
    return node.n_spheres > 0 && n_blockers == node.n_spheres;
