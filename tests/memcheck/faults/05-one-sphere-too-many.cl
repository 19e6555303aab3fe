// fault: asks the sphere behind the last
// lab: 05-spheres
// task: nearest_hit
// says: reads outside of a buffer
    for (int i = 0; i <= n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);  // HERE
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
