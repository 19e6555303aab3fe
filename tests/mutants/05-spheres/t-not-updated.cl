// mutant: hit.t is not updated
// task: nearest_hit
// caught by: hit-nearest
// says: hit.t were never set
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.sphere = i;
        }
    }
