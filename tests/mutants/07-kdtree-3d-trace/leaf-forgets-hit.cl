// mutant: the hit so far is thrown away
// task: search_leaf
// caught by: leaf-nearest
// says: hit so far
    Hit own = {INFINITY, NO_SPHERE};
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < own.t) {
            own.t = t;
            own.sphere = id;
        }
    }
    if (own.sphere != NO_SPHERE) {
        *hit = own;
    }
