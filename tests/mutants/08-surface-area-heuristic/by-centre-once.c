// mutant: a sphere is in the bin of its centre, and in one child
// task: find_best_split
// caught by: best-plane
// says: not by its centre
    (void)planes_up_to;
    for (u32 axis = 0; axis < 3; axis++) {
        const Planes planes = axis_planes(box, axis);
        u32 n_in[N_BINS] = {0};
        for (u32 i = 0; i < n_ids; i++) {
            Sphere point = h_spheres[ids[i]];
            point.radius = 0;
            const f32 centre = sphere_range(point, axis).begin;
            n_in[planes_below(&planes, centre)]++;
        }
        u32 n_lower = 0, n_higher = n_ids;
        for (int plane = 1; plane < N_BINS; plane++) {
            n_lower += n_in[plane - 1];
            n_higher -= n_in[plane - 1];
            const KdSplit split = {axis, candidate_plane(box, axis, plane)};
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < best.cost) {
                best = (BestSplit){split, cost};
            }
        }
    }
