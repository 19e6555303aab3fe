// mutant: the index is kept in 16 bits
// task: nearest_hit
// caught by: hit-nearest
// says: 16 bits
    ushort nearest = 0;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit.t = t;
            nearest = (ushort)i;
        }
    }
    if (hit.t < INFINITY) {
        hit.sphere = nearest;
    }
