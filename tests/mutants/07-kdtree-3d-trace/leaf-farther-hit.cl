// mutant: the comparison is inverted, but a miss is no hit
// task: search_leaf
// caught by: leaf-ids
// says: farther than
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < INFINITY && t > hit->t) {
            hit->t = t;
            hit->sphere = id;
        }
    }
