// mutant: hits close to the end do not count
// task: leaf_blocks
// caught by: blocks-edges
// says: without an epsilon
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < 0.9998f * ray.t_max) {
            return 1;
        }
    }
