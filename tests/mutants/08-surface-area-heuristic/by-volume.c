// mutant: a child's share of the side, as if points were asked
// task: split_cost
// caught by: cost-planes
// says: volume
    const double whole = (double)box.max[split.axis] - box.min[split.axis];
    const double share = ((double)split.pos - box.min[split.axis]) / whole;
    return KD_COST_TRAVERSAL + KD_COST_TEST * (share * n_lower + (1 - share) * n_higher);
