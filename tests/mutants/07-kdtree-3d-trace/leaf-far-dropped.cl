// mutant: hits farther than a million are dropped
// task: search_leaf
// caught by: leaf-nearest
// says: far
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < 1e6f && (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere))) {
            hit->t = t;
            hit->sphere = id;
        }
    }
