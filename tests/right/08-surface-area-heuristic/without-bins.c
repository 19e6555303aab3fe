// right: every plane asks every sphere: slow, and by the contract's words
// task: find_best_split
    for (u32 axis = 0; axis < 3; axis++) {
        for (int plane = 1; plane < N_BINS; plane++) {
            const KdSplit split = {axis, candidate_plane(box, axis, plane)};
            u32 n_lower = 0, n_higher = 0;
            for (u32 i = 0; i < n_ids; i++) {
                const Range range = sphere_range(h_spheres[ids[i]], axis);
                n_lower += range.begin <= split.pos;
                n_higher += range.end >= split.pos;
            }
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < best.cost) {
                best.split = split;
                best.cost = cost;
            }
        }
    }
