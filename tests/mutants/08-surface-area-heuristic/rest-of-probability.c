// mutant: the second probability is 1 minus the first
// task: split_cost
// caught by: cost-planes
// says: met one child alone
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double p_lower = surface_area(lower) / surface_area(box);
    return KD_COST_TRAVERSAL + KD_COST_TEST * (p_lower * n_lower + (1 - p_lower) * n_higher);
