// mutant: who ends in a bin leaves the higher child one plane too late
// task: find_best_split
// caught by: best-plane
// says: not in its higher child any more
    for (u32 axis = 0; axis < 3; axis++) {
        const Planes planes = axis_planes(box, axis);
        u32 begins[N_BINS] = {0}, ends[N_BINS] = {0};
        for (u32 i = 0; i < n_ids; i++) {
            const Range range = sphere_range(h_spheres[ids[i]], axis);
            begins[planes_below(&planes, range.begin)]++;
            ends[planes_up_to(&planes, range.end)]++;
        }
        u32 n_lower = 0, n_higher = n_ids;
        for (int i = 1; i < N_BINS; i++) {
            n_lower += begins[i - 1];
            n_higher -= i > 1 ? ends[i - 2] : 0;
            const KdSplit split = {axis, candidate_plane(box, axis, i)};
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < best.cost) {
                best.split = split;
                best.cost = cost;
            }
        }
    }
