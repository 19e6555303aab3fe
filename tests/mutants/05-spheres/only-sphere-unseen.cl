// mutant: a scene of one sphere shows nothing, as its last one is not asked
// task: nearest_hit
// caught by: hit-edges
// says: last sphere were missing$
    for (int i = 0; i < n_spheres - 1; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
