// mutant: nearer by more than an epsilon: hits a hair apart and ties stay
// task: search_leaf
// caught by: leaf-nearest
// says: a hair apart
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t - 1e-5f) {
            hit->t = t;
            hit->sphere = id;
        }
    }
