// mutant: what is missed blocks
// task: leaf_blocks
// caught by: blocks-before
// says: misses block
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) > ray.t_max) {
            return 1;
        }
    }
