// mutant: the loop starts at 1
// task: nearest_hit
// caught by: hit-work
// says: called
    for (int i = 1; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
