// right: the leaf's range from its end
// task: search_leaf
    uint left = node.n_spheres;
    global const uint *ids = sphere_ids + node.first;
    Hit best = *hit;
    while (left > 0) {
        left--;
        const float t = intersect_sphere(spheres[ids[left]], ray, work);
        if (t < best.t || (t == best.t && t < INFINITY && ids[left] < best.sphere)) {
            best = (Hit){t, ids[left]};
        }
    }
    *hit = best;
