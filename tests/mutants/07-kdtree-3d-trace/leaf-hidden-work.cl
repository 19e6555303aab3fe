// mutant: spheres are asked by a way that is not counted
// task: search_leaf
// caught by: leaf-once
// says: called 0 times
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const Sphere sphere = spheres[id];
        const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
        const float b = dot(c, ray.direction);
        const float3 l = c - b * ray.direction;
        const float disc = sphere.radius * sphere.radius - dot(l, l);
        const float t = nearest_root(b, disc, sphere.radius, ray.t_min);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
