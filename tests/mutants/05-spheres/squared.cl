// mutant: the search stops at distance 4
// task: nearest_hit
// caught by: hit-nearest
// says: found
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t && t < 4.0f) {
            hit.t = t;
            hit.sphere = i;
        }
    }
