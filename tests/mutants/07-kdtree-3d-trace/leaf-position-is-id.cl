// mutant: hit->sphere is the position in sphere_ids
// task: search_leaf
// caught by: leaf-ids
// says: position
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && i < hit->sphere)) {
            hit->t = t;
            hit->sphere = i;
        }
    }
