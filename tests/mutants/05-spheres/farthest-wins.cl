// mutant: the farthest hit
// task: nearest_hit
// caught by: hit-nearest
// says: farthest
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < INFINITY && (hit.sphere == NO_SPHERE || t > hit.t)) {
            hit.t = t;
            hit.sphere = i;
        }
    }
