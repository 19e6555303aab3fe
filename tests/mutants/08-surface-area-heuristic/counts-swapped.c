// mutant: the lower area with the count of the higher child
// task: split_cost
// caught by: cost-planes
// says: other one
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(lower) * n_higher + surface_area(higher) * n_lower) /
               surface_area(box);
