// mutant: 16 bits are to hold the id of a sphere
// task: search_leaf
// caught by: leaf-nearest
// says: longest leaf
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const ushort id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
