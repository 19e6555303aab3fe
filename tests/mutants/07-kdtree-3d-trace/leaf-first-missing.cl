// mutant: the first sphere is not asked
// task: search_leaf
// caught by: leaf-nearest
// says: first sphere of the leaf is missing
// looks: missing-in-cell
    for (uint i = node.first + 1; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
