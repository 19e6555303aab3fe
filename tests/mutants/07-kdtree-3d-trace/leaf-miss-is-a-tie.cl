// mutant: a miss is as far as no hit so far, and every id is lower than NO_SPHERE
// task: search_leaf
// caught by: leaf-ids
// says: miss was taken for a hit
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
