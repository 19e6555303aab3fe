// mutant: a nearer sphere must have a lower id, too
// task: search_leaf
// caught by: leaf-nearest
// says: whatever its id
    for (uint i = 0; i < node.n_spheres; i++) {
        const uint id = sphere_ids[node.first + i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t > ray.t_min && t < ray.t_max && t <= hit->t && id < hit->sphere) {
            hit->t = t;
            hit->sphere = id;
        }
    }
