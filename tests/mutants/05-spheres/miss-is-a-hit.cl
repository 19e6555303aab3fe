// mutant: a miss is stored, too
// task: nearest_hit
// caught by: hit-edges
// says: found
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t || i == 0) {
            hit.t = t;
            hit.sphere = i;
        }
    }
