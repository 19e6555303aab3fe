// mutant: nearer by a millionth of the distance
// task: nearest_hit
// caught by: hit-nearest
// says: so small
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t * 0.999999f) {
            hit.t = t;
            hit.sphere = (uint)i;
        }
    }
