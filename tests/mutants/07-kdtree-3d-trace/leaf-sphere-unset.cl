// mutant: hit->sphere is not set
// task: search_leaf
// caught by: leaf-ids
// says: not set
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
        }
    }
