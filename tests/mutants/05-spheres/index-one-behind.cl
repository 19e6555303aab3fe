// mutant: counted from 1
// task: nearest_hit
// caught by: hit-nearest
// says: found
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t && i + 1 < n_spheres) {
            hit.t = t;
            hit.sphere = i + 1;
        }
    }
