// mutant: 8 bits are to hold how many spheres a leaf has
// task: search_leaf
// caught by: leaf-nearest
// says: longest leaf
    const uchar n_spheres = (uchar)node.n_spheres;
    for (uint i = node.first; i < node.first + n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
