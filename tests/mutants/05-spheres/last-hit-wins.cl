// mutant: the last hit, however far
// task: nearest_hit
// caught by: hit-nearest
// says: last sphere that is hit
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < INFINITY) {
            hit.t = t;
            hit.sphere = i;
        }
    }
