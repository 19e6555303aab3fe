// mutant: hit.sphere is not updated
// task: nearest_hit
// caught by: hit-nearest
// says: hit.sphere were never set
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
        }
    }
