// mutant: the id that is kept is the tree's, not the leaf's
// task: search_leaf
// caught by: leaf-ids
// says: id that is kept
    for (uint i = 0; i < node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[node.first + i]], ray, work);
        if (t < hit->t) {
            hit->t = t;
            hit->sphere = sphere_ids[i];
        }
    }
