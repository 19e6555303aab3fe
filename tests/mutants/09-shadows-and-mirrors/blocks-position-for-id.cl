// mutant: i is taken for the id
// task: leaf_blocks
// caught by: blocks-before
// says: a position, not an id
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[i], ray, work) < ray.t_max) {
            return 1;
        }
    }
