// fault: the next sphere is read ahead of its turn, also behind the last one
// lab: 05-spheres
// task: nearest_hit
// says: reads spheres
    Sphere next = spheres[0];
    for (int i = 0; i < n_spheres; i++) {
        const Sphere sphere = next;
        next = spheres[i + 1];  // HERE
        const float t = intersect_sphere(sphere, ray, work);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
