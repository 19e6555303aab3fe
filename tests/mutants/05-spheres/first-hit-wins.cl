// mutant: the first hit, however far
// task: nearest_hit
// caught by: hit-nearest
// says: first sphere that is hit
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
            break;
        }
    }
