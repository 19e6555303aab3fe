// mutant: KD_COST_TEST forgotten
// task: split_cost
// caught by: cost-planes
// says: not 1
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           (surface_area(lower) * n_lower + surface_area(higher) * n_higher) / surface_area(box);
