// mutant: a hit as far as the light blocks it, too
// task: leaf_blocks
// caught by: blocks-edges
// says: at the end itself
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) <= ray.t_max) {
            return 1;
        }
    }
