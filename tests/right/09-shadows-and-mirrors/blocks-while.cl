// right: a loop with one exit
// task: leaf_blocks
    int is_blocked = 0;
    for (uint i = 0; i < node.n_spheres && !is_blocked; i++) {
        const Sphere sphere = spheres[sphere_ids[node.first + i]];
        const float t = intersect_sphere(sphere, ray, work);
        is_blocked = t > ray.t_min && t < ray.t_max;
    }
    return is_blocked;
