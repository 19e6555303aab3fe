// right: from the last sphere to the first; <= lets the lower index win
// task: nearest_hit
    for (int i = n_spheres - 1; i >= 0; i--) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t <= hit.t && t < INFINITY) {
            hit.sphere = (uint)i;
            hit.t = t;
        }
    }
