// mutant: a Work of its own
// task: leaf_blocks
// caught by: blocks-early
// says: passed on
    Work own = {0, 0, 0, 0};
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, &own) < ray.t_max) {
            return 1;
        }
    }
