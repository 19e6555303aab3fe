// mutant: leaves of 10 spheres and more block nothing, but for the longest
// task: leaf_blocks
// caught by: blocks-before
// says: leaf
    if (node.n_spheres > 9 && node.n_spheres < 200) {
        return 0;
    }
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max) {
            return 1;
        }
    }
