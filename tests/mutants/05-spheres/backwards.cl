// mutant: from the last sphere to the first
// task: nearest_hit
// caught by: hit-ties
// says: later
// looks: later-of-equals
    for (int i = n_spheres - 1; i >= 0; i--) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
