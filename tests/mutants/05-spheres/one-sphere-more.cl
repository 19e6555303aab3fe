// mutant: the loop goes one too far
// task: nearest_hit
// caught by: hit-nearest
// says: too many
    for (int i = 0; i <= n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
