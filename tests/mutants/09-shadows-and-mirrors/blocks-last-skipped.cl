// mutant: the leaf's last sphere is not asked
// task: leaf_blocks
// caught by: blocks-before
// says: last sphere was not asked
    for (uint i = node.first; i + 1 < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t < ray.t_max) {
            return 1;
        }
    }
