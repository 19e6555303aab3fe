// mutant: cost and axis of the best plane are kept, its position is not
// task: find_best_split
// caught by: best-plane
// says: not its position
    for (u32 axis = 0; axis < 3; axis++) {
        const Planes planes = axis_planes(box, axis);
        u32 n_begin[N_BINS] = {0}, n_end[N_BINS] = {0};
        for (u32 i = 0; i < n_ids; i++) {
            const Range range = sphere_range(h_spheres[ids[i]], axis);
            n_begin[planes_below(&planes, range.begin)]++;
            n_end[planes_up_to(&planes, range.end)]++;
        }
        u32 n_lower = 0, n_higher = n_ids;
        for (int plane = 1; plane < N_BINS; plane++) {
            n_lower += n_begin[plane - 1];
            n_higher -= n_end[plane - 1];
            const KdSplit split = {axis, planes.pos[plane]};
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < best.cost) {
                best.cost = cost;
                best.split.axis = axis;
            }
        }
    }
