// mutant: of equal axes the last one
// task: find_best_split
// caught by: best-ties
// says: x counts before y
    for (u32 axis = 0; axis < 3; axis++) {
        const Planes planes = axis_planes(box, axis);
        u32 begins[N_BINS] = {0}, ends[N_BINS] = {0};
        for (u32 i = 0; i < n_ids; i++) {
            const Range range = sphere_range(h_spheres[ids[i]], axis);
            begins[planes_below(&planes, range.begin)]++;
            ends[planes_up_to(&planes, range.end)]++;
        }
        BestSplit here = {{axis, 0}, INFINITY};
        u32 n_lower = 0, n_higher = n_ids;
        for (int i = 1; i < N_BINS; i++) {
            n_lower += begins[i - 1];
            n_higher -= ends[i - 1];
            const KdSplit split = {axis, candidate_plane(box, axis, i)};
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < here.cost) {
                here = (BestSplit){split, cost};
            }
        }
        if (here.cost <= best.cost && here.cost < INFINITY) {
            best = here;
        }
    }
