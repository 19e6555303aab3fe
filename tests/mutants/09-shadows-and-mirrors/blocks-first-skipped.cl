// mutant: from the second sphere on
// task: leaf_blocks
// caught by: blocks-before
// says: first sphere was not asked
    for (uint i = node.first + 1; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max) {
            return 1;
        }
    }
