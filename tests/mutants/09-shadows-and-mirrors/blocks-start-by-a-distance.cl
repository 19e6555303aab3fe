// mutant: hits nearer than a thousandth do not count
// task: leaf_blocks
// caught by: blocks-edges
// says: near to the start
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t > 0.001f && t < ray.t_max) {
            return 1;
        }
    }
