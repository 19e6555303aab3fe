// mutant: the textbook's form is asked
// task: nearest_hit
// caught by: hit-work
// says: called
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_textbook(spheres[i], ray);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
