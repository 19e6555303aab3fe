// mutant: the count is taken for the end of the range
// task: leaf_blocks
// caught by: blocks-before
// says: no leaf blocks
    for (uint i = node.first; i < node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max) {
            return 1;
        }
    }
