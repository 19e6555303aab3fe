// mutant: one sphere too many is asked, the one before the leaf's
// task: search_leaf
// caught by: leaf-ids
// says: too many is asked, the one before
    for (uint i = node.first ? node.first - 1 : 0; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
