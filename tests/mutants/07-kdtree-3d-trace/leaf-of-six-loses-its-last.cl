// mutant: of more than 5 spheres the last one is not asked
// task: search_leaf
// caught by: leaf-nearest
// says: .
    for (uint i = node.first; i < node.first + node.n_spheres - (node.n_spheres > 5); i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
