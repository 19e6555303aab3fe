// mutant: a sphere like the one before is not asked
// task: nearest_hit
// caught by: hit-work
// says: like the one before
    for (int i = 0; i < n_spheres; i++) {
        if (i > 0 && spheres[i].x == spheres[i - 1].x && spheres[i].y == spheres[i - 1].y &&
            spheres[i].z == spheres[i - 1].z && spheres[i].radius == spheres[i - 1].radius) {
            continue;
        }
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < hit.t) {
            hit = (Hit){t, (uint)i};
        }
    }
