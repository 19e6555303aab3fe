// mutant: <= for <: a miss, infinitely far, is taken for a hit
// task: nearest_hit
// caught by: hit-ties
// says: miss.*were a hit
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t <= hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
