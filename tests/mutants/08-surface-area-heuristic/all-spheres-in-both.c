// mutant: each child counts all spheres
// task: split_cost
// caught by: cost-planes
// says: its own spheres
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double p = surface_area(lower) / surface_area(box);
    const double q = surface_area(higher) / surface_area(box);
    return KD_COST_TRAVERSAL + KD_COST_TEST * (p + q) * (n_lower + n_higher);
