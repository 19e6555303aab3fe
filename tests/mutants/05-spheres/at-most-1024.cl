// mutant: at most 1024 spheres are asked
// task: nearest_hit
// caught by: hit-nearest
// says: found
    for (int i = 0; i < min(n_spheres, 1024); i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = (uint)i;
        }
    }
