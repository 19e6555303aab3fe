// mutant: the first sphere is not asked: not what its distance or size explains
// task: nearest_hit
// caught by: hit-nearest
// says: first sphere were missing$
    for (int i = 1; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
