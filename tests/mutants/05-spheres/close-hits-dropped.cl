// mutant: hits close to the eye do not count
// task: nearest_hit
// caught by: hit-nearest
// says: so close
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t > 1e-4f && t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
