// mutant: no more than 64 spheres of a leaf are asked
// task: search_leaf
// caught by: leaf-nearest
// says: longest leaf
    for (uint i = node.first; i < node.first + min(node.n_spheres, 64u); i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
