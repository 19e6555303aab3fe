// right: first the nearest of the leaf, then the nearer of that and the hit so far
// task: search_leaf
    Hit own = {INFINITY, NO_SPHERE};
    for (uint i = 0; i < node.n_spheres; i++) {
        const uint id = sphere_ids[node.first + i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < own.t) {
            own = (Hit){t, id};
        }
    }
    if (own.t < hit->t || (own.t == hit->t && own.sphere < hit->sphere)) {
        *hit = own;
    }
