// right: a distance that is not finite is no hit, and the smaller one is kept by fmin
// task: nearest_hit
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (isfinite(t) && isgreater(hit.t, t)) {
            hit.sphere = i;
        }
        hit.t = fmin(hit.t, t);
    }
