// mutant: the sphere that is hit already is not asked again
// task: search_leaf
// caught by: leaf-once
// says: hit already
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        if (id == hit->sphere) {
            continue;
        }
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
