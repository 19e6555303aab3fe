// mutant: every sphere is asked twice
// task: nearest_hit
// caught by: hit-work
// says: asked twice|more than once
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = intersect_sphere(spheres[i], ray, work);
            hit.sphere = i;
        }
    }
