// mutant: the hit so far stays where a sphere with a lower id is just as far away
// task: search_leaf
// caught by: leaf-ids
// says: lower id
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t) {
            hit->t = t;
            hit->sphere = id;
        }
    }
