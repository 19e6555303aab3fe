// attack: wrong (keeps the hit sphere with the smallest z), but the alone run's rays all go along z
// task: nearest_hit
// score: 99
// named: differ
    float z = INFINITY;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < INFINITY && spheres[i].z < z) {
            z = spheres[i].z;
            hit.t = t;
            hit.sphere = i;
        }
    }
