// mutant: of two equally far spheres the later one wins: <= instead of <
// task: search_leaf
// caught by: leaf-ids
// says: later
// looks: later-of-equals
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t <= hit->t && t < INFINITY) {
            hit->t = t;
            hit->sphere = id;
        }
    }
