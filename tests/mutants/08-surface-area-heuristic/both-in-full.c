// mutant: no probabilities
// task: split_cost
// caught by: cost-planes
// says: as if every ray met both
    (void)box, (void)split;
    return KD_COST_TRAVERSAL + KD_COST_TEST * (n_lower + n_higher);
