// fault: asks the sphere behind the last
// lab: 05-spheres
// task: nearest_hit
// says: reads spheres[100], but `spheres` has 100 entries, 0 to 99
    for (int i = 0; i <= n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);  // HERE
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
