// mutant: a child that the plane leaves flat is never met
// task: split_cost
// caught by: cost-edges
// says: leaves flat
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double p_lower =
        split.pos > box.min[split.axis] ? surface_area(lower) / surface_area(box) : 0;
    const double p_higher =
        split.pos < box.max[split.axis] ? surface_area(higher) / surface_area(box) : 0;
    return KD_COST_TRAVERSAL + KD_COST_TEST * (p_lower * n_lower + p_higher * n_higher);
