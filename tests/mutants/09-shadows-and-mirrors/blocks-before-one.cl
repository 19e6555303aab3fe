// mutant: the end is at t = 1
// task: leaf_blocks
// caught by: blocks-before
// says: not at 1
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < 1.0f) {
            return 1;
        }
    }
