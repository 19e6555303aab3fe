// mutant: calls are counted in a copy of work
// task: nearest_hit
// caught by: hit-work
// says: not counted
    Work mine = *work;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, &mine);
        if (t < hit.t) {
            hit = (Hit){t, (uint)i};
        }
    }
