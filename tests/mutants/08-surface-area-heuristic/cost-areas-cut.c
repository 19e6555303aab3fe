// mutant: areas are kept in whole numbers
// task: split_cost
// caught by: cost-planes
// says: found
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const int a = (int)surface_area(lower), b = (int)surface_area(higher);
    return KD_COST_TRAVERSAL + KD_COST_TEST * (a * (double)n_lower + b * (double)n_higher) / surface_area(box);
