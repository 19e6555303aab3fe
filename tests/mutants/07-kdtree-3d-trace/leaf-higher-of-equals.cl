// mutant: of equally far spheres the higher id wins
// task: search_leaf
// caught by: leaf-ids
// says: higher id won
    for (uint k = 0; k < node.n_spheres; k++) {
        const uint sphere = sphere_ids[node.first + k];
        const float t = intersect_sphere(spheres[sphere], ray, work);
        const bool is_tie = t == hit->t && t < INFINITY;
        if (t < hit->t || (is_tie && sphere > hit->sphere)) {
            *hit = (Hit){t, sphere};
        }
    }
