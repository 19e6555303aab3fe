// mutant: the range starts at 0
// task: search_leaf
// caught by: leaf-nearest
// says: first ids of the tree
    for (uint i = 0; i < node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
