// mutant: spheres are asked with a count of their own
// task: search_leaf
// caught by: leaf-once
// says: not counted
    (void)work;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        Work own = {0, 0, 0, 0};
        const float t = intersect_sphere(spheres[id], ray, &own);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
