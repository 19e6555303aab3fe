// right: what is not nearer is skipped; the hit is a whole structure
// task: nearest_hit
    for (uint i = 0; i < (uint)n_spheres; ++i) {
        const Hit found = {intersect_sphere(spheres[i], ray, work), i};
        if (found.t >= hit.t) {
            continue;
        }
        hit = found;
    }
