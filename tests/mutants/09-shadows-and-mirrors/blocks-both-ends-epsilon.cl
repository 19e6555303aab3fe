// mutant: an epsilon at the start and at the end
// task: leaf_blocks
// caught by: blocks-edges
// says: start or to the end
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t > ray.t_min + 0.001f && t < ray.t_max - 0.001f) {
            return 1;
        }
    }
