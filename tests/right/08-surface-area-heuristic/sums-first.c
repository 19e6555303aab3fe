// right: both sums for all planes, then the costs; the higher child is summed from above
// task: find_best_split
    for (u32 axis = 0; axis < 3; axis++) {
        const Planes planes = axis_planes(box, axis);
        u32 n_lower[N_BINS + 1] = {0}, n_higher[N_BINS + 1] = {0};
        for (u32 i = 0; i < n_ids; i++) {
            const Range range = sphere_range(h_spheres[ids[i]], axis);
            n_lower[planes_below(&planes, range.begin) + 1]++;
            n_higher[planes_up_to(&planes, range.end)]++;
        }
        for (int plane = 2; plane < N_BINS; plane++) {
            n_lower[plane] += n_lower[plane - 1];
        }
        for (int plane = N_BINS - 1; plane > 0; plane--) {
            n_higher[plane] += n_higher[plane + 1];
        }
        for (int plane = 1; plane < N_BINS; plane++) {
            const KdSplit split = {axis, candidate_plane(box, axis, plane)};
            const double cost = split_cost(box, split, n_lower[plane], n_higher[plane]);
            best = cost < best.cost ? (BestSplit){split, cost} : best;
        }
    }
