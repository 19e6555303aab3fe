// mutant: the first sphere is not counted
// task: find_best_split
// caught by: best-plane
// says: too many or too few|another plane is cheaper
    const Planes planes[3] = {axis_planes(box, 0), axis_planes(box, 1), axis_planes(box, 2)};
    u32 n_begin[3][N_BINS] = {0}, n_end[3][N_BINS] = {0};
    for (u32 i = 1; i < n_ids; i++) {
        for (u32 axis = 0; axis < 3; axis++) {
            const Range range = sphere_range(h_spheres[ids[i]], axis);
            n_begin[axis][planes_below(&planes[axis], range.begin)]++;
            n_end[axis][planes_up_to(&planes[axis], range.end)]++;
        }
    }
    for (u32 axis = 0; axis < 3; axis++) {
        u32 n_lower = 0, n_higher = n_ids;
        for (int plane = 1; plane < N_BINS; plane++) {
            n_lower += n_begin[axis][plane - 1];
            n_higher -= n_end[axis][plane - 1];
            const KdSplit split = {axis, planes[axis].pos[plane]};
            const double cost = split_cost(box, split, n_lower, n_higher);
            if (cost < best.cost) {
                best.split = split;
                best.cost = cost;
            }
        }
    }
