// mutant: no division by the area of the cell
// task: split_cost
// caught by: cost-planes
// says: not divided
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(lower) * n_lower + surface_area(higher) * n_higher);
