// mutant: a sphere that is hit is asked twice
// task: search_leaf
// caught by: leaf-once
// says: more than once
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = intersect_sphere(spheres[id], ray, work);
            hit->sphere = id;
        }
    }
