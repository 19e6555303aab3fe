// right: a local nearest, stored when it is one
// task: search_leaf
    float nearest = hit->t;
    uint winner = hit->sphere;
    const uint end = node.first + node.n_spheres;
    for (uint i = node.first; i != end; ++i) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t > nearest || t == INFINITY) {
            continue;
        }
        winner = t == nearest ? min(winner, sphere_ids[i]) : sphere_ids[i];
        nearest = t;
    }
    hit->t = nearest;
    hit->sphere = winner;
