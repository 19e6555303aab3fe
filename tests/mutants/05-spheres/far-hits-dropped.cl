// mutant: the search ends at a distance of a million
// task: nearest_hit
// caught by: hit-nearest
// says: so far
    float nearest = 1e6f;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < nearest) {
            nearest = t;
            hit.t = t;
            hit.sphere = i;
        }
    }
