// mutant: the probabilities are made to add up to 1
// task: split_cost
// caught by: cost-planes
// says: do not add up to 1
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const double a = surface_area(lower), b = surface_area(higher);
    return KD_COST_TRAVERSAL + KD_COST_TEST * (a * n_lower + b * n_higher) / (a + b);
