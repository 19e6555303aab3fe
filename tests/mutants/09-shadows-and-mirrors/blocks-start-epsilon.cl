// mutant: hits close to the start do not count
// task: leaf_blocks
// caught by: blocks-edges
// says: without an epsilon
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t > 0.0002f * ray.t_max && t < ray.t_max) {
            return 1;
        }
    }
