// mutant: spheres[] is asked by the position in sphere_ids
// task: search_leaf
// caught by: leaf-nearest
// says: position in sphere_ids was taken
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        (void)sphere_ids;
        const uint id = i;
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
