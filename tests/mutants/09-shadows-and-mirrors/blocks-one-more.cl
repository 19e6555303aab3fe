// mutant: the sphere behind the leaf is asked
// task: leaf_blocks
// caught by: blocks-before
// says: one sphere too many
    for (uint i = node.first; i <= node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max) {
            return 1;
        }
    }
