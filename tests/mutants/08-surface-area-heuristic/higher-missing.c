// mutant: only the lower child
// task: split_cost
// caught by: cost-planes
// says: higher child is missing
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    (void)n_higher;
    return KD_COST_TRAVERSAL + KD_COST_TEST * surface_area(lower) * n_lower / surface_area(box);
