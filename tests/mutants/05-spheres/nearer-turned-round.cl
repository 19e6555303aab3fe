// mutant: the comparison is turned round: no hit is nearer than none
// task: nearest_hit
// caught by: hit-nearest
// says: found nothing
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t > hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
