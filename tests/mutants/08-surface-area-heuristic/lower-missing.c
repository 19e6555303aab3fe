// mutant: only the higher child
// task: split_cost
// caught by: cost-planes
// says: lower child is missing
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    (void)n_lower;
    return KD_COST_TRAVERSAL + KD_COST_TEST * surface_area(higher) * n_higher / surface_area(box);
