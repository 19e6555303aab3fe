// mutant: spheres with a negative radius are left out
// task: leaf_blocks
// caught by: blocks-before
// says: negative radius is in the way
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (spheres[sphere_ids[i]].radius < 0.0f) {
            continue;
        }
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t < ray.t_max) {
            return 1;
        }
    }
