// mutant: the first ids of the tree
// task: leaf_blocks
// caught by: blocks-before
// says: begin at node.first
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i - node.first]], ray, work) < ray.t_max) {
            return 1;
        }
    }
