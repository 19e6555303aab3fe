// mutant: what is farther by less than a millionth wins, too
// task: nearest_hit
// caught by: hit-nearest
// says: so small
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < INFINITY && t < hit.t * 1.000001f && t != hit.t) {
            hit.t = t;
            hit.sphere = (uint)i;
        }
    }
