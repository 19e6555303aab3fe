// mutant: a distance that is equal takes the place, also INFINITY
// task: search_leaf
// caught by: leaf-ids
// says: and of misses
// looks: later-of-equals
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t <= hit->t) {
            hit->t = t;
            hit->sphere = id;
        }
    }
