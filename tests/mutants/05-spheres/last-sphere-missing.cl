// mutant: the loop ends one too early
// task: nearest_hit
// caught by: hit-work
// says: called
    for (int i = 0; i < n_spheres - 1; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
