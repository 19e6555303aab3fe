// mutant: a sphere around the start is left out
// task: leaf_blocks
// caught by: blocks-before
// says: around the start
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const Sphere sphere = spheres[sphere_ids[i]];
        if (distance((float3)(sphere.x, sphere.y, sphere.z), ray.origin) < fabs(sphere.radius)) {
            continue;
        }
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t < ray.t_max) {
            return 1;
        }
    }
