// mutant: of equal distances the later sphere
// task: nearest_hit
// caught by: hit-ties
// says: later
// looks: later-of-equals
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t <= hit.t && t < INFINITY) {
            hit.t = t;
            hit.sphere = i;
        }
    }
