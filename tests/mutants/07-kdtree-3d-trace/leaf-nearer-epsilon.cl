// mutant: a hit counts as nearer only when it is nearer by 1e-4
// task: search_leaf
// caught by: leaf-nearest
// says: epsilon
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t - 1e-4f || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
