// mutant: n_spheres is taken for the end of the range
// task: search_leaf
// caught by: leaf-once
// says: end of the range
    for (uint i = node.first; i < node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
