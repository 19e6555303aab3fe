// mutant: a split with an empty child is a fifth cheaper
// task: split_cost
// caught by: cost-edges
// says: has no bonus
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double cost =
        KD_COST_TRAVERSAL + KD_COST_TEST *
                                (surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
                                surface_area(box);
    return n_lower == 0 || n_higher == 0 ? 0.8 * cost : cost;
