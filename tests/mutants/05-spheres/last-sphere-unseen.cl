// mutant: the last sphere is not asked: not what its distance or size explains
// task: nearest_hit
// caught by: hit-nearest
// says: last sphere were missing$
    for (int i = 0; i < n_spheres - 1; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
