// right: from the last sphere to the first
// task: leaf_blocks
    for (uint left = node.n_spheres; left > 0; left--) {
        const uint id = sphere_ids[node.first + left - 1];
        if (intersect_sphere(spheres[id], ray, work) < ray.t_max) {
            return 1;
        }
    }
