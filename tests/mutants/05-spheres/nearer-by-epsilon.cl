// mutant: nearer means nearer by an epsilon
// task: nearest_hit
// caught by: hit-nearest
// says: so small
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t - 1e-5f) {
            hit.t = t;
            hit.sphere = i;
        }
    }
